#include "report/result/study_plots.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <numeric>

#include "report/result/study_page.hpp"
#include "frf/hdf5/table_file.hpp"
#include "report/page/contents.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double without_value = std::numeric_limits<double>::quiet_NaN();

class StudyPlots : public testing::Test {
 protected:
  /// Trials of which number i has the values `base` + i of all unknowns, and one matrix with figures of merit.
  std::filesystem::path study_file(std::size_t unknowns, std::size_t trials, double base, double truth) const {
    const std::filesystem::path path = folder_ / "study.h5";
    frf::TableHeader header{{{"unknowns", std::to_string(unknowns)}, {"judged", "stiffness"}, {"intervals", "no"}},
                            {{"status", "", without_value}}};
    for (std::size_t u = 0; u < unknowns; ++u) header.columns.push_back({"K" + std::to_string(u), "N/m", truth});
    for (const char* figure : {"rjcf", "arvf", "error"}) header.columns.push_back({figure, "", without_value});
    frf::TableWriter table(path, header, trials);
    for (std::size_t i = 0; i < trials; ++i) {
      std::vector<double> row(unknowns + 4, base + static_cast<double>(i));
      row[0] = 0.0;
      row[unknowns + 1] = 1.0 - 0.001 * static_cast<double>(i);
      row[unknowns + 2] = 1.0 + 0.001 * static_cast<double>(i);
      row[unknowns + 3] = 0.5;
      table.append(row);
    }
    table.finish();
    return path;
  }

 private:
  TestFolder folder_;
};

report::PlotGroup unknowns_of(const std::filesystem::path& file, std::size_t most) {
  const study::StudyStatistics statistics = study::study_statistics(file);
  return report::study_unknown_plots(tasks::unknown_histograms(file, statistics, most), statistics, most);
}

report::PlotGroup quality_of(const std::filesystem::path& file) {
  const study::StudyStatistics statistics = study::study_statistics(file);
  return report::study_quality_plots(tasks::quality_histograms(file, statistics), statistics);
}

const report::HistogramPlot& histogram(const report::PlotGroup& group, std::size_t choice, std::size_t plot) {
  return std::get<report::HistogramPlot>(group.choices.at(choice).plots.at(plot));
}

double sum(const std::vector<double>& counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); }

/// As the workbench draws trials that go on.
TEST_F(StudyPlots, OfValuesInMemoryAreThoseOfTheFile) {
  const report::PlotGroup of_file = unknowns_of(study_file(1, 200, 1000.0, 1090.0), 10);
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(1000.0 + i);
  values.push_back(without_value);
  const auto in_memory = tasks::histogram_of("K0", "N/m", values, 1090.0);
  ASSERT_TRUE(in_memory);
  const report::HistogramPlot found = report::histogram_plot(*in_memory);
  EXPECT_EQ(found.counts, histogram(of_file, 0, 0).counts);
  EXPECT_EQ(found.low, histogram(of_file, 0, 0).low);
  EXPECT_EQ(found.high, histogram(of_file, 0, 0).high);
  EXPECT_EQ(found.title, histogram(of_file, 0, 0).title);
  EXPECT_FALSE(tasks::histogram_of("K0", "N/m", std::vector<double>(10, 3.0), std::nullopt));
  EXPECT_FALSE(tasks::histogram_of("K0", "N/m", {without_value}, std::nullopt));
}

TEST_F(StudyPlots, CountEveryTrialAndMarkTheTruth) {
  const report::PlotGroup group = unknowns_of(study_file(1, 100, 0.0, 40.0), 10);
  const report::HistogramPlot& plot = histogram(group, 0, 0);
  EXPECT_EQ(plot.title, "K0");
  EXPECT_EQ(plot.x.label, "N/m");
  EXPECT_EQ(sum(plot.counts), 100.0);
  EXPECT_LT(plot.low, 0.0);
  EXPECT_GT(plot.high, 99.0);
  EXPECT_EQ(plot.mark, 40.0);
}

TEST_F(StudyPlots, ReachForATruthThatIsNearOnly) {
  EXPECT_GT(histogram(unknowns_of(study_file(1, 100, 0.0, 200.0), 10), 0, 0).high, 200.0);
  EXPECT_LT(histogram(unknowns_of(study_file(1, 100, 0.0, 2e6), 10), 0, 0).high, 200.0);
}

TEST_F(StudyPlots, StandTwelveTogetherAndEndWhereAsked) {
  const report::PlotGroup group = unknowns_of(study_file(40, 30, 0.0, without_value), 25);
  ASSERT_EQ(group.choices.size(), 3U);
  EXPECT_EQ(group.choices[0].name, "K0 … K11");
  EXPECT_EQ(group.choices[0].plots.size(), 12U);
  EXPECT_EQ(group.choices[2].name, "K24");
  EXPECT_FALSE(histogram(group, 2, 0).mark.has_value());
}

TEST_F(StudyPlots, WhatDoesNotVaryIsLeftOut) {
  EXPECT_TRUE(unknowns_of(study_file(2, 1, 5.0, 5.0), 10).choices.empty());
  const auto file = study_file(1, 50, 0.0, without_value);
  const report::PlotGroup group = quality_of(file);
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].plots.size(), 2U) << "the rms error is always 0.5";
}

TEST_F(StudyPlots, RjcfEndsAtOne) {
  const auto file = study_file(1, 50, 0.0, without_value);
  const report::PlotGroup group = quality_of(file);
  EXPECT_EQ(histogram(group, 0, 0).high, 1.0);
  EXPECT_EQ(sum(histogram(group, 0, 0).counts), 50.0);
  EXPECT_GT(histogram(group, 0, 1).high, 1.0);
}

class StudyReportPage : public StudyPlots {};

TEST_F(StudyReportPage, TellsTheSceneAndStaysSmall) {
  const auto file = study_file(1000, 30, 0.0, 10.0);
  const tasks::StudyResult result{"title", file.string(), 7, {}, study::study_statistics(file)};
  ident::Scene scene;
  scene.title = "A <joint>";
  scene.noise = ident::NoiseSection{"uniform", 0.05, {}};
  const std::string page = report::study_page(result, scene, tasks::study_histograms(file, result.statistics, report::most_unknowns_shown));
  EXPECT_THAT(page, HasSubstr("<h1>A &lt;joint&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr("<dd>30, 30 with an estimate</dd>"));
  EXPECT_THAT(page, HasSubstr("<dd>uniform, level 0.05</dd>"));
  EXPECT_THAT(page, HasSubstr("First 300 of 1000 unknowns"));
  EXPECT_THAT(page, Not(HasSubstr("coverage")));
  EXPECT_LT(page.size(), 500'000U);
}

}  // namespace
}  // namespace jointid::cli
