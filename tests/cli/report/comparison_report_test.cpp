#include <gmock/gmock.h>

#include "../comparison_sample.hpp"
#include "report/result/comparison_page.hpp"
#include "cli/problem/reproduction_page.hpp"
#include "report/page/contents.hpp"
#include "report/result/comparison_plots.hpp"

namespace jointid::cli {
namespace {

using report::error_against_time;

using testing::HasSubstr;
using testing::Not;

TEST(ComparisonPlots, PointsAreNamedByWhatDiffers) {
  const report::ScatterPlot plot = error_against_time(sample_comparison().comparison.combinations, 0);
  ASSERT_EQ(plot.groups.size(), 2U);
  EXPECT_EQ(plot.groups[0].name, "Δ 0");
  EXPECT_EQ(plot.groups[1].points[0].label, "Δ 0.05");
  EXPECT_DOUBLE_EQ(plot.groups[1].points[0].x, 2.0);
  EXPECT_EQ(plot.groups[1].points[0].y, 0.3);
  ASSERT_EQ(plot.front.size(), 1U);
  EXPECT_EQ(plot.front[0].y, 0.3);
}

TEST(ComparisonPlots, ColourTellsTheWeightingFirst) {
  auto combinations = sample_comparison().comparison.combinations;
  combinations[0].way.weighting = weighting::Weighting::wa;
  combinations[0].way.method = ident::Method::two;
  const report::ScatterPlot plot = error_against_time(combinations, 0);
  EXPECT_EQ(plot.groups[0].name, "WA");
  EXPECT_EQ(plot.groups[0].points[0].label, "WA, method two, Δ 0");
}

TEST(ComparisonPlots, AxesAreLogarithmicOverMoreThanADecade) {
  auto combinations = sample_comparison().comparison.combinations;
  EXPECT_FALSE(error_against_time(combinations, 0).x.log);
  combinations[0].solve_s = 0.1;
  EXPECT_TRUE(error_against_time(combinations, 0).x.log);
  EXPECT_FALSE(error_against_time(combinations, 0).y.log);
}

TEST(ComparisonPlots, FrontAscendsAndWithoutAnEstimateThereIsNoPoint) {
  auto combinations = sample_comparison().comparison.combinations;
  combinations.push_back(sample_combination(0.1, NAN, false));
  combinations[0].matrices[0].on_front = true;
  combinations[1].solve_s = 0.001;
  const report::ScatterPlot plot = error_against_time(combinations, 0);
  EXPECT_EQ(plot.groups.size(), 2U);
  ASSERT_EQ(plot.front.size(), 2U);
  EXPECT_LT(plot.front[0].x, plot.front[1].x);
}

ident::Scene sample_scene() {
  ident::Scene scene;
  scene.file = "folder/joint.toml";
  scene.noise = ident::NoiseSection{"hammer", 0.0, {}};
  return scene;
}

TEST(ComparisonReportPage, HasFiguresCostAndWhatWasLeftOut) {
  const std::string page = report::comparison_page(sample_comparison(), sample_scene());
  EXPECT_THAT(page, HasSubstr("<p>jointid compare joint.toml</p>"));
  EXPECT_THAT(page, HasSubstr("hammer, coherence 0.998, 5 averages"));
  EXPECT_THAT(page, HasSubstr("<td>0.9876 1.0123</td>"));
  EXPECT_THAT(page, HasSubstr("<td>0.1 … 1</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"left\">*</td>"));
  EXPECT_THAT(page, HasSubstr("<td>4.0</td><td class=\"left\">7 ok</td>"));
  EXPECT_THAT(page, HasSubstr("two all WB 0 qr: no such block"));
  EXPECT_THAT(page, HasSubstr("\"kind\":\"scatter\""));
}

TEST(ComparisonReportPage, SaysWhenNothingWasFound) {
  tasks::ComparisonResult report = sample_comparison();
  report.comparison.combinations = {sample_combination(0.0, NAN, false)};
  report.comparison.left_out.clear();
  const std::string page = report::comparison_page(report, sample_scene());
  EXPECT_THAT(page, HasSubstr("No combination gave an estimate."));
  EXPECT_THAT(page, Not(HasSubstr("Left out")));
}

TEST(ReproductionReportPage, MarksInsideOutsideAndDoubtful) {
  const problems::ThesisTable& table = problems::thesis_table("6.8");
  ReproductionReport report{table, 10, 1, std::vector<problems::Reproduced>(table.entries.size())};
  report.results[0] = {{0.1, 0.25, 0.5}, true};
  const std::string page = reproduction_report(report);
  EXPECT_THAT(page, HasSubstr("1 of 63 entries of the print lie inside"));
  EXPECT_THAT(
      page,
      HasSubstr(
          "<td class=\"inside\">0.8960 <span title=\"inside\">✓</span><strong>0.25</strong><small>0.1…<br>0.5</small></td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"outside\">0.8964 <span title=\"outside\">✗</span>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"unsure\">0.90690 <span title=\"doubtful print\">?</span>"));
  EXPECT_THAT(page, HasSubstr("has a digit too many"));
}

/// Tables whose rows have other columns are kept apart.
TEST(ReproductionReportPage, KeepsColumnsTogether) {
  const problems::ThesisTable& table = problems::thesis_table("6.5");
  const ReproductionReport report{table, 10, 1, std::vector<problems::Reproduced>(table.entries.size())};
  const std::string page = reproduction_report(report);
  std::size_t tables = 0;
  for (std::size_t at = page.find("class=\"compared\""); at != std::string::npos; at = page.find("class=\"compared\"", at + 1)) ++tables;
  EXPECT_EQ(tables, 2U);
}

}  // namespace
}  // namespace jointid::cli
