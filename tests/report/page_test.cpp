#include "report/page/page.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "report/page/status_banner.hpp"
#include "sample_page.hpp"

namespace jointid::report {
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
  ASSERT_EQ(plots.size(), 5U);
  EXPECT_EQ(plots[0]["choices"][1]["name"], nasty);
  const auto& first = plots[0]["choices"][0]["plots"];
  EXPECT_EQ(first[0]["values"].size(), 100U);
  EXPECT_EQ(first[1]["values"], "same");
  EXPECT_TRUE(first[0]["series"][0]["y"][9].is_null());
  EXPECT_EQ(first[0]["band"], nlohmann::json({20.0, 60.0}));
  EXPECT_EQ(plots[1]["choices"][0]["plots"][0]["groups"][1]["points"][1][2], nasty);
  EXPECT_EQ(plots[2]["choices"][0]["plots"][0]["mark"]["name"], "truth");
}

TEST(ReportPage, AFrontHasTheNameItIsGiven) {
  const auto plots = plots_of(sample_page().html());
  EXPECT_EQ(plots[1]["choices"][0]["plots"][0]["frontName"], "Pareto front");
  const auto& poles = plots[3]["choices"][0]["plots"][0];
  EXPECT_TRUE(poles["front"].empty());
  EXPECT_EQ(poles["backdrop"]["values"].size(), poles["backdrop"]["series"][0]["y"].size());
}

TEST(ReportPage, StripsAndPhasesTellTheirAxes) {
  const auto strips = plots_of(sample_page().html())[4]["choices"][0]["plots"];
  EXPECT_EQ(strips[0]["deviation"], 0.1);
  EXPECT_FALSE(strips[0].contains("yRange"));
  EXPECT_EQ(strips[1]["yRange"], nlohmann::json({-270.0, 90.0}));
  EXPECT_EQ(strips[1]["series"][0]["style"], "reference points");
}

TEST(ReportPage, TheStatusStandsAboveAllElseInItsColour) {
  ReportPage page("title", "");
  page.section("Summary");
  page.status(status_banner("poor_fit", "far off", {"remark"},
                            {{"sign", "a.h5", "1:+Y", "evidence", "flip = [\"1:+Y\"]"}, {"axis", "", "", "", ""}}));
  const std::string html = page.html();
  EXPECT_LT(html.find("class=\"verdict bad\""), html.find("<h2>Summary"));
  EXPECT_THAT(html, HasSubstr("<strong class=\"word\">poor fit</strong><p>far off</p><p>remark</p>"));
  EXPECT_THAT(html, HasSubstr("<li><strong>sign</strong> <span class=\"where\">a.h5, 1:+Y</span><p>evidence</p>"
                              "<pre>flip = [&quot;1:+Y&quot;]</pre></li>"));
  EXPECT_THAT(html, HasSubstr("<li><strong>axis</strong></li>"));
}

TEST(ReportPage, ColoursOfStatuses) {
  for (const char* status : {"ok", "clean"}) EXPECT_EQ(status_banner(status, "").trust, Trust::good) << status;
  for (const char* status : {"doubtful", "suspicious"}) EXPECT_EQ(status_banner(status, "").trust, Trust::doubtful) << status;
  for (const char* status : {"poor_fit", "rank_deficient", "no_equations", "not_converged", "imprecise", "wrong", "no_modes"}) {
    EXPECT_EQ(status_banner(status, "").trust, Trust::bad) << status;
  }
}

TEST(ReportPage, ACutTableSaysSo) {
  Table table({{"name", Align::left}, {"value"}});
  for (int i = 0; i < 5; ++i) table.add({"row" + std::to_string(i), "1"});
  ReportPage cut("title", ""), whole("title", "");
  cut.add(table, "", {3});
  whole.add(table, "", {5});
  EXPECT_THAT(cut.html(), HasSubstr("First 3 of 5 rows; --json and --csv write all of them."));
  EXPECT_THAT(cut.html(), Not(HasSubstr("row3")));
  EXPECT_THAT(whole.html(), Not(HasSubstr("First")));
  EXPECT_THAT(whole.html(), HasSubstr("row4"));
}

TEST(ReportPage, OnlyLongTextsOfTablesAreBroken) {
  Table table({{"name", Align::left}, {"text", Align::left}});
  table.add({"short", std::string(60, 'x')});
  ReportPage page("title", "");
  page.add(table);
  EXPECT_THAT(page.html(), HasSubstr("<th scope=\"row\">short</th><td class=\"left long\">xxx"));
}

TEST(ReportPage, ErrorsOfFrfsAreColouredByTheirSize) {
  ReportPage page("title", "");
  page.add(sample_heat_map());
  const std::string html = page.html();
  EXPECT_THAT(html, HasSubstr("<td class=\"h0\" title=\"1:+Y / 1:+Y: 0.05 dB\">0.05</td><td class=\"h1\""));
  EXPECT_THAT(html, HasSubstr("<td class=\"h5\" title=\"1:+Y / 3:+Y: 12.0 dB\">12.0</td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"none\"></td><td class=\"h3\""));
  EXPECT_THAT(html, HasSubstr(">123</td>"));
  EXPECT_THAT(html, HasSubstr("<span class=\"h2\">0.3 to 1</span>"));
}

/// Of too many rows those with the largest totals stay, in their order.
TEST(ReportPage, AMapThatIsTooLargeKeepsItsWorstRows) {
  HeatMap map{"map", {}, {"c"}, {}, {}, {1.0}};
  for (int i = 0; i < 200; ++i) {
    map.rows.push_back("r" + std::to_string(i) + ":+X");
    map.values.push_back(i % 2 == 0 ? 0.01 : 1.0 + i);
    map.row_totals.push_back(map.values.back());
  }
  ReportPage page("title", "");
  page.add(map);
  const std::string html = page.html();
  EXPECT_THAT(html, HasSubstr("The 48 of 200 responses with the largest errors."));
  EXPECT_EQ(count(html, "<th scope=\"row\">r"), 48U);
  EXPECT_LT(html.find("r105:+X"), html.find("r199:+X"));
  EXPECT_THAT(html, Not(HasSubstr("r103:+X")));
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
}  // namespace jointid::report
