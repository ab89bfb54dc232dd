#include "minimise/least_squares.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/require.hpp"

namespace jointid::minimise {
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
  if (!has_ceres()) JOINTID_SKIP("this build lacks Ceres");
  const Minimum found = ceres_minimum(Valley(), start);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.q[0], 1.0, 1e-10);
  EXPECT_NEAR(found.q[1], 1.0, 1e-10);
}

TEST(LeastSquares, IpoptFindsTheSame) {
  if (!has_ipopt()) JOINTID_SKIP("this build lacks Ipopt");
  const Minimum found = ipopt_minimum(Valley(), start);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.q[0], 1.0, 1e-8);
  EXPECT_NEAR(found.q[1], 1.0, 1e-8);
}

TEST(LeastSquares, IpoptStopsAtABound) {
  if (!has_ipopt()) JOINTID_SKIP("this build lacks Ipopt");
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Minimum found = ipopt_minimum(Valley(), start, {.lower = {-inf, -inf}, .upper = {0.5, inf}});
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.q[0], 0.5, 1e-7);  // then q1 = q0²
  EXPECT_NEAR(found.q[1], 0.25, 1e-7);
}

}  // namespace
}  // namespace jointid::minimise
