#include "report/page/solve_plots.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/statistics.hpp"
#include "report/page/plot_json.hpp"

namespace jointid::report {
namespace {

using testing::ElementsAre;
using testing::Le;

tasks::RegeneratedFrf frf(const char* response, const char* reference, std::vector<Complex> measured,
                          std::vector<Complex> predicted) {
  return {{frf::Dof::parse(response), frf::Dof::parse(reference)}, std::move(measured), std::move(predicted)};
}

TEST(SolvePlots, MagnitudeAndPhaseOfBoth) {
  const tasks::Regenerated data = {{10.0, 20.0}, {frf("1:+Y", "2:+RZ", {{0, 1}, {0, 0}}, {{0, 2}, {-3, 0}})}};
  const PlotGroup group = frf_overlay(data, {}, 100);
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].name, "1:+Y / 2:+RZ (6.02 dB, FRAC 1.000000, LAC 0.800000)");
  const auto& magnitude = std::get<CurvePlot>(group.choices[0].plots[0]);
  const auto& difference = std::get<CurvePlot>(group.choices[0].plots[1]);
  const auto& phase = std::get<CurvePlot>(group.choices[0].plots[2]);
  EXPECT_EQ(magnitude.y.label, "receptance (m/(N·m))");
  EXPECT_THAT(magnitude.series[0].y, ElementsAre(1.0, testing::IsNan()));
  EXPECT_THAT(magnitude.series[1].y, ElementsAre(2.0, 3.0));
  EXPECT_THAT(difference.series[0].y, ElementsAre(testing::DoubleNear(20.0 * std::log10(2.0), 1e-12), testing::IsNan()));
  EXPECT_EQ(difference.level, 0.0);
  EXPECT_THAT(phase.series[1].y, ElementsAre(90.0, 180.0));
}

TEST(SolvePlots, ObjectiveAndUnknownsOverTheIterations) {
  const tasks::UnknownsByIteration found{{"K(1,1)", "D(1,1)", "k0"},
                                         {{1, 40.0, {5.0, 1.0, 3.0}}, {3, 4.0, {8.0, 8.0, 2.0}}, {4, {}, {10.0, 4.0, 0.0}}}};
  const PlotGroup group = iteration_plots(found);
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].name, "1 to 2 of 2") << "what is 0 at the end has no ratio";
  const auto& objective = std::get<CurvePlot>(group.choices[0].plots[0]);
  const auto& unknowns = std::get<CurvePlot>(group.choices[0].plots[1]);
  EXPECT_THAT(objective.x_values, ElementsAre(1.0, 3.0, 4.0));
  EXPECT_TRUE(objective.y.log);
  EXPECT_THAT(objective.series[0].y, ElementsAre(40.0, 4.0, testing::IsNan()));
  EXPECT_EQ(unknowns.series[0].name, "D(1,1)") << "it moved most";
  EXPECT_THAT(unknowns.series[0].y, ElementsAre(0.25, 2.0, 1.0));
  EXPECT_THAT(unknowns.series[1].y, ElementsAre(0.5, 0.8, 1.0));
  EXPECT_TRUE(iteration_plots({}).choices.empty());
}

TEST(SolvePlots, EightUnknownsShareAPlot) {
  tasks::UnknownsByIteration found;
  for (int u = 0; u < 50; ++u) found.names.push_back("k" + std::to_string(u));
  for (std::size_t step = 1; step < 4; ++step)
    found.iterations.push_back({step, -1.0, std::vector<double>(50, static_cast<double>(step))});
  const PlotGroup group = iteration_plots(found);
  ASSERT_EQ(group.choices.size(), 5U);
  EXPECT_EQ(group.choices[4].name, "33 to 40 of 50");
  EXPECT_EQ(std::get<CurvePlot>(group.choices[4].plots[1]).series.size(), 8U);
  EXPECT_FALSE(std::get<CurvePlot>(group.choices[0].plots[0]).y.log);
}

TEST(SolvePlots, WhatIsNotThereIsLeftOut) {
  const tasks::Regenerated data = {{10.0}, {frf("1:+Y", "2:+Y", {nan}, {1.0}), frf("1:+Y", "1:+Y", {1.0}, {Complex(nan, nan)})}};
  const PlotGroup group = frf_overlay(data, {}, 100);
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].name, "1:+Y / 1:+Y");
  EXPECT_EQ(std::get<CurvePlot>(group.choices[0].plots[0]).series.size(), 1U);
  EXPECT_EQ(group.choices[0].plots.size(), 2U) << "no difference of one curve";
}

TEST(SolvePlots, AnFrfThatVanishesBySymmetryIsLeftOut) {
  const tasks::Regenerated data = {{10.0}, {frf("1:+Y", "1:+Y", {1.0}, {1.0}), frf("1:+Y", "1:+X", {1e-17}, {1e-18})}};
  EXPECT_EQ(frf_overlay(data, {}, 100).choices.size(), 1U);
}

TEST(SolvePlots, AHundredThousandLinesStaySmall) {
  const std::size_t lines = 100000;
  tasks::Regenerated data;
  std::vector<Complex> values;
  for (std::size_t i = 0; i < lines; ++i) {
    data.frequency_hz.push_back(0.0123456789 * static_cast<double>(i));
    values.push_back(std::polar(1e-7 / (1.0 + static_cast<double>(i * 7919 % 1000)), static_cast<double>(i)));
  }
  data.frfs.assign(16, frf("1:+Y", "2:+Y", values, values));
  EXPECT_THAT(plot_json(frf_overlay(data, {}, 2400)).size(), Le(4'000'000U));
}

TEST(SolvePlots, OneQualityPlotPerMatrix) {
  using restrictions::Kind;
  const std::vector<tasks::LineQuality> lines = {{2, 10.0, {{Kind::stiffness, {0.5, 0.6, 0.1}}}},
                                                 {3, 20.0, {{Kind::stiffness, {0.9, 1.1, 0.1}}}}};
  const PlotGroup group = quality_plots(lines);
  ASSERT_EQ(group.choices.size(), 1U);
  const auto& plot = std::get<CurvePlot>(group.choices[0].plots[0]);
  EXPECT_THAT(plot.x_values, ElementsAre(2.0, 3.0));
  EXPECT_THAT(plot.series[0].y, ElementsAre(0.5, 0.9));
  EXPECT_THAT(plot.series[1].y, ElementsAre(0.6, 1.1));
  EXPECT_TRUE(quality_plots({}).choices.empty());
}

}  // namespace
}  // namespace jointid::report
