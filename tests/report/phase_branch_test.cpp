#include "report/page/phase_branch.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "report/phase_branch.hpp"

namespace jointid::report {
namespace {

using jointid::report::crossings;

using testing::Each;
using testing::ElementsAre;

constexpr double deg = 180.0 / std::numbers::pi;

/// Phase of a driving point with a lightly damped mode at 50 Hz, with relative noise.
std::vector<double> driving_point(double sign, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out;
  for (int i = 1; i <= 400; ++i) {
    const double f = 0.25 * i;
    const std::complex<double> h = sign / std::complex<double>(1.0 - f * f / 2500.0, 0.001 * f / 50.0);
    out.push_back(std::arg(h * std::complex<double>(1.0 + noise * normal(random), noise * normal(random))) * deg);
  }
  return out;
}

TEST(PhaseBranch, NoiseAroundHalfATurnDoesNotFlicker) {
  for (const double sign : {1.0, -1.0}) {
    CurvePlot plot;
    plot.series = {{"measured", driving_point(sign, 0.05, 1), Style::reference},
                   {"regenerated", driving_point(sign, 0.01, 2), Style::line}};
    ASSERT_GT(crossings(plot.series[0].y, 180.0), 50U);
    choose_branch(plot);
    const double end = (*plot.y_range)[1];
    for (const Series& series : plot.series) {
      EXPECT_LE(crossings(series.y, end), 1U) << series.name << " " << sign;
      EXPECT_THAT(series.y, Each(testing::AllOf(testing::Gt(end - 360.0), testing::Le(end))));
      EXPECT_NE(series.style, Style::points);
    }
  }
}

TEST(PhaseBranch, TheUsualPeriodStaysWhereItIsAsGood) {
  CurvePlot plot;
  plot.series = {{"clean", driving_point(1.0, 0.0, 1), Style::line}};
  const std::vector<double> before = plot.series[0].y;
  choose_branch(plot);
  EXPECT_EQ((*plot.y_range)[1], 180.0);
  EXPECT_EQ(plot.series[0].y, before);
}

TEST(PhaseBranch, BothCurvesStayTogether) {
  CurvePlot plot;
  plot.series = {{"a", {179.0, -179.0, 178.0, -177.0}, Style::reference}, {"b", {-179.0, 179.0, -178.0, 177.0}, Style::line}};
  choose_branch(plot);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(std::abs(plot.series[0].y[i] - plot.series[1].y[i]), 6.0);
}

TEST(PhaseBranch, PhasesOfNoiseArePoints) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-180.0, 180.0);
  CurvePlot plot;
  plot.series = {{"measured", {}, Style::reference}, {"other", {}, Style::line}};
  for (int i = 0; i < 500; ++i) {
    for (Series& series : plot.series) series.y.push_back(any(random));
  }
  choose_branch(plot);
  EXPECT_EQ(plot.series[0].style, Style::reference_points);
  EXPECT_EQ(plot.series[1].style, Style::points);
}

TEST(PhaseBranch, WhatIsNotThereCrossesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(crossings({170.0, nan, -170.0}, 180.0), 0U);
  EXPECT_EQ(crossings({170.0, -170.0, 170.0}, 180.0), 2U);
  CurvePlot plot;
  plot.series = {{"gaps", {nan, nan}, Style::line}};
  choose_branch(plot);
  EXPECT_THAT(plot.series[0].y, ElementsAre(testing::IsNan(), testing::IsNan()));
}

}  // namespace
}  // namespace jointid::report
