#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "base/complex.hpp"
#include "base/statistics.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::weighting {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;


std::vector<double> axis(double first, double step, std::size_t lines) {
  std::vector<double> frequency(lines);
  for (std::size_t i = 0; i < lines; ++i) frequency[i] = first + static_cast<double>(i) * step;
  return frequency;
}

/// Σ|H|² of two point FRFs with modes at 100, 180 and 310 Hz, 1 % damped, and a rigid-body mode, each real
/// and imaginary part times a factor in [1−level, 1+level].
std::vector<double> three_modes(const std::vector<double>& frequency, double level) {
  const double natural[] = {0.0, 100.0, 180.0, 310.0};
  const double shape[2][4] = {{1.0, 1.0, 0.7, 0.9}, {1.0, -0.8, 1.0, 0.6}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> factor(1.0 - level, 1.0 + level);
  std::vector<double> indicator;
  for (const double f : frequency) {
    double sum = 0.0;
    for (const auto& modes : shape) {
      Complex h = 0.0;
      for (std::size_t r = 0; r < 4; ++r)
        h += modes[r] * modes[r] / (natural[r] * natural[r] * Complex(1.0, 0.01) - f * f);
      const double re = h.real() * factor(random), im = h.imag() * factor(random);
      sum += re * re + im * im;
    }
    indicator.push_back(sum);
  }
  return indicator;
}

TEST(FindResonances, FindsThreeModesUnderFivePercentNoise) {
  const std::vector<double> frequency = axis(20.0, 0.25, 1600);
  EXPECT_THAT(find_resonances(frequency, three_modes(frequency, 0.0)),
              ElementsAre(DoubleNear(100.0, 0.5), DoubleNear(180.0, 0.5), DoubleNear(310.0, 0.5)));
  EXPECT_THAT(find_resonances(frequency, three_modes(frequency, 0.05)),
              ElementsAre(DoubleNear(100.0, 0.6), DoubleNear(180.0, 1.0), DoubleNear(310.0, 1.5)));
}

TEST(FindResonances, InventsNoneOnSmoothCurves) {
  const std::vector<double> frequency = axis(0.0, 1.0, 500);
  std::vector<double> mass(500), spring(500, 1.0), zero(500, 0.0);
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = i == 0 ? nan : std::pow(frequency[i], -4.0);
  EXPECT_THAT(find_resonances(frequency, mass), IsEmpty());
  EXPECT_THAT(find_resonances(frequency, spring), IsEmpty());
  EXPECT_THAT(find_resonances(frequency, zero), IsEmpty());
}

TEST(FindResonances, InventsNoneBesideALineAtZeroHertz) {
  // s = f²·indicator is zero at 0 Hz whatever was measured there.
  const std::vector<double> frequency = axis(0.0, 1.0, 500);
  std::vector<double> free_body(500, 1e6);
  for (std::size_t i = 1; i < free_body.size(); ++i) free_body[i] = std::pow(frequency[i], -4.0);
  EXPECT_THAT(find_resonances(frequency, free_body), IsEmpty());
}

TEST(FindResonances, LinesThatWereNotMeasuredAreSkipped) {
  const std::vector<double> frequency = axis(20.0, 0.25, 1600);
  std::vector<double> indicator = three_modes(frequency, 0.05);
  for (const std::size_t line : {0u, 1u, 250u, 251u, 500u, 900u, 1300u, 1599u}) indicator[line] = nan;
  EXPECT_EQ(find_resonances(frequency, indicator).size(), 3u);
  EXPECT_THAT(find_resonances(frequency, std::vector<double>(1600, nan)), IsEmpty());
}

TEST(FindResonances, APeakNeedsBothFlanks) {
  const std::vector<double> frequency = {1.0, 1.0 + 1e-9, 1.0 + 2e-9, 1.0 + 3e-9, 1.0 + 4e-9};
  EXPECT_THAT(find_resonances(frequency, std::vector<double>{1.0, 2.1, 4.0, 2.1, 1.9}),
              ElementsAre(frequency[2]));
  EXPECT_THAT(find_resonances(frequency, std::vector<double>{1.0, 2.1, 4.0, 3.0, 2.1}), IsEmpty());
  EXPECT_THAT(find_resonances(frequency, std::vector<double>{4.0, 2.1, 1.9, 1.0, 0.1}), IsEmpty());
  EXPECT_THAT(find_resonances({}, {}), IsEmpty());
}

}  // namespace
}  // namespace jointid::weighting
