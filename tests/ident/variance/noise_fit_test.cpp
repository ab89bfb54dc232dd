#include "ident/variance/noise_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace jointid::ident {
namespace {

/// Squared errors of σ² = a|H|² + b with |H|² from 1e-4 to 1, a share of them from errors ten times as large.
std::vector<SquaredError> samples_of(double a, double b, double freedom, std::size_t count, double gross, unsigned seed) {
  std::mt19937_64 random(seed);
  std::gamma_distribution<double> gamma(freedom);
  std::uniform_real_distribution<double> uniform;
  std::vector<SquaredError> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const double square = std::pow(10.0, -4.0 * uniform(random));
    const double factor = uniform(random) < gross ? 100.0 : 1.0;
    samples.push_back({factor * (a * square + b) * gamma(random) / freedom, square, 1.0, freedom});
  }
  return samples;
}

RC_GTEST_PROP(NoiseFit, FindsBothTermsInAnyUnit, (unsigned seed)) {
  const double a = 1e-4 * *rc::gen::inRange(1, 100), b = a * std::pow(10.0, -*rc::gen::inRange(0, 4));
  const double unit = std::pow(10.0, *rc::gen::inRange(-12, 4));
  auto samples = samples_of(a, b, 4.0, 2000, 0.0, seed);
  for (SquaredError& sample : samples) {
    sample.square *= unit;
    sample.proportional *= unit;
  }
  const frf::VarianceLaw law = fit_noise(samples);
  for (const double square : {1e-4, 1e-2, 1.0}) {
    const double expected = unit * (a * square + b), found = 2.0 * law(std::sqrt(unit * square), 1.0).real();
    RC_ASSERT(std::abs(found / expected - 1.0) < 0.2);
  }
}

RC_GTEST_PROP(NoiseFit, IsNeverNegative, (unsigned seed)) {
  const bool relative = *rc::gen::arbitrary<bool>();
  const frf::VarianceLaw law = fit_noise(samples_of(relative ? 1e-3 : 0.0, relative ? 0.0 : 1e-3, 1.0, 50, 0.0, seed));
  RC_ASSERT(law.proportional >= 0.0 && law.constant >= 0.0);
  RC_ASSERT(law.proportional + law.constant > 0.0);
}

TEST(NoiseFit, ShrugsOffGrossLines) {
  const auto clean = fit_noise(samples_of(1e-3, 1e-5, 1.0, 4000, 0.0, 1));
  const auto gross = fit_noise(samples_of(1e-3, 1e-5, 1.0, 4000, 0.05, 1));
  for (const double value : {0.01, 0.1, 1.0}) {
    EXPECT_NEAR(gross(value, 1.0).real() / clean(value, 1.0).real(), 1.0, 0.25);
  }
}

TEST(NoiseFit, OfNothingIsZero) {
  EXPECT_EQ(fit_noise({}).proportional, 0.0);
  EXPECT_EQ(fit_noise({}).constant, 0.0);
}

}  // namespace
}  // namespace jointid::ident
