#include "friction/least_squares.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "friction/parameter_scale.hpp"

namespace jointid::friction {
namespace {

/// Rosenbrock's valley, minimum 0 at (1, 1); not defined beyond q0 = 3.
class Valley final : public LeastSquares {
 public:
  std::size_t unknowns() const override { return 2; }
  std::size_t residuals() const override { return 2; }
  bool evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const override {
    r[0] = 10.0 * (q[1] - q[0] * q[0]);
    r[1] = 1.0 - q[0];
    if (!jacobian.empty()) {
      jacobian[0] = -20.0 * q[0];
      jacobian[1] = 10.0;
      jacobian[2] = -1.0;
      jacobian[3] = 0.0;
    }
    return q[0] < 3.0;
  }
};

const std::vector<double> start = {-1.2, 1.0};

TEST(LeastSquares, ThePatternSearchWalksThroughTheValley) {
  const Valley valley;
  const Minimum found = pattern_search([&](std::span<const double> q) { return valley.objective(q); }, start);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.q[0], 1.0, 1e-6);
  EXPECT_NEAR(found.q[1], 1.0, 1e-6);
}

TEST(LeastSquares, ThePatternSearchSaysWhenItRanOutOfEvaluations) {
  const Valley valley;
  EXPECT_FALSE(pattern_search([&](std::span<const double> q) { return valley.objective(q); }, start, {.most_evaluations = 20}).converged);
}

TEST(LeastSquares, CeresFindsTheSame) {
  if (!has_ceres()) GTEST_SKIP() << "this build lacks Ceres";
  const Minimum found = ceres_minimum(Valley(), start);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.q[0], 1.0, 1e-10);
  EXPECT_NEAR(found.q[1], 1.0, 1e-10);
}

TEST(LeastSquares, TheGlobalSearchStaysWhereTheProblemIsDefined) {
  if (!has_nlopt()) GTEST_SKIP() << "this build lacks NLopt";
  const Valley valley;
  const std::vector<double> found = nlopt_global(valley, start, 8.0, 3000);
  EXPECT_LT(valley.objective(found), 0.1);
}

TEST(ParameterScale, GoesThereAndBackAndItsSlopeIsTheDerivative) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<Parameter> parameters = {{"k", "", 3e7, 0.0, inf}, {"b", "", 2.5, 0.0, 700.0}, {"c", "", -4e13, -inf, 0.0},
                                             {"x", "", -0.4, -1.0, 0.0}, {"y", "", 7.0, -inf, inf}};
  for (const Parameter& parameter : parameters) {
    const ParameterScale scale(parameter);
    const double q = scale.free(parameter.value);
    EXPECT_NEAR(scale.value(q), parameter.value, 1e-13 * std::abs(parameter.value)) << parameter.name;
    const double difference = (scale.value(q + 1e-5) - scale.value(q - 1e-5)) / 2e-5;
    EXPECT_NEAR(scale.slope(q), difference, 1e-8 * std::abs(difference)) << parameter.name;
    for (const double far : {-30.0, 30.0}) {
      EXPECT_GE(scale.value(far), parameter.lower);
      EXPECT_LE(scale.value(far), parameter.upper);
    }
  }
}

TEST(ParameterScale, ABoundIsTakenALittleInside) {
  const ParameterScale scale({"b", "", 0.0, 0.0, 700.0, true});
  EXPECT_TRUE(std::isfinite(scale.free(0.0)));
  EXPECT_NEAR(scale.value(scale.free(0.0)), 0.0, 1e-6);
}

}  // namespace
}  // namespace jointid::friction
