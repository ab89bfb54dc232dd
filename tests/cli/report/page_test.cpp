#include "cli/report/page.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "sample_page.hpp"

namespace jointid::cli::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The plots' descriptions, as the page's program reads them.
nlohmann::json plots_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"plots\">";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(ReportPage, NoTextBreaksOut) {
  const std::string page = sample_page().html();
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
  EXPECT_EQ(count(page, "</script>"), 3U);
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
}

TEST(ReportPage, LoadsNothing) {
  const std::string page = sample_page().html();
  EXPECT_FALSE(std::regex_search(page, std::regex("<(link|img|iframe|object)[ >]|src=|href=|@import|url\\(")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(ReportPage, PlotsCarryWhatTheirNamesSay) {
  const auto plots = plots_of(sample_page().html());
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[0]["choices"][1]["name"], nasty);
  const auto& first = plots[0]["choices"][0]["plots"];
  EXPECT_EQ(first[0]["values"].size(), 100U);
  EXPECT_EQ(first[1]["values"], "same");
  EXPECT_TRUE(first[0]["series"][0]["y"][9].is_null());
  EXPECT_EQ(first[0]["band"], nlohmann::json({20.0, 60.0}));
  EXPECT_EQ(plots[1]["choices"][0]["plots"][0]["groups"][1]["points"][1][2], nasty);
  EXPECT_EQ(plots[2]["choices"][0]["plots"][0]["mark"]["name"], "truth");
}

TEST(ReportPage, WithoutPlotsThereIsNoProgram) {
  ReportPage page("title", "");
  page.section("Text");
  page.add(Text{"words"});
  page.add(PlotGroup{"FRF", {}});
  EXPECT_THAT(page.html(), Not(HasSubstr("uPlot=")));
  EXPECT_THAT(page.html(), Not(HasSubstr("data-group=\"0\"")));
}

TEST(ReportPage, NumbersAreShort) {
  ReportPage page("title", "");
  page.add(PlotGroup{"", {{"", {CurvePlot{"", {}, {}, {100.123456789012}, {{"", {1.0 / 3.0}}}, {}, {}, {}}}}}});
  EXPECT_THAT(page.html(), HasSubstr("\"values\":[100.123457]"));
  EXPECT_THAT(page.html(), HasSubstr("\"y\":[0.333333]"));
}

TEST(ReportPage, BarsStandWhereTheirValuesAre) {
  ReportPage page("title", "");
  page.add(Bars{{{"K(1,1)", 2.0, "N/m", {{1.0, 4.0}}, 3.0, ""}, {"K(1,2)", -1.0, "N/m", {}, {}, "doubtful"}}});
  const std::string html = page.html();
  EXPECT_THAT(html, HasSubstr("<rect x=\"50.00%\" width=\"25.00%\""));
  EXPECT_THAT(html, HasSubstr("<rect x=\"37.50%\" width=\"12.50%\""));
  EXPECT_THAT(html, HasSubstr("class=\"interval\" x1=\"62.50%\" x2=\"100.00%\""));
  EXPECT_THAT(html, HasSubstr("class=\"truth\" x1=\"87.50%\""));
  EXPECT_THAT(html, HasSubstr("<small>doubtful</small>"));
}

TEST(ReportPage, WithoutIntervalsThereIsNoColumnForThem) {
  ReportPage page("title", "");
  page.add(Bars{{{"K", 2.0, "N/m", {}, {}, ""}}});
  EXPECT_THAT(page.html(), Not(HasSubstr("95 % interval")));
  EXPECT_THAT(page.html(), HasSubstr("<rect x=\"0.00%\" width=\"100.00%\""));
}

TEST(ReportPage, MatricesTellTheirDeviationFromTheTruth) {
  const std::string page = sample_page().html();
  EXPECT_THAT(page, HasSubstr("1e+06<small>-9.09 %</small>"));
  EXPECT_THAT(page, HasSubstr("-1e+06<small>+0 %</small>"));
}

}  // namespace
}  // namespace jointid::cli::report
