#include "response/continuation/peak_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "friction/law/laws.hpp"
#include "response/equivalent/equivalent_mode.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

Eigen::MatrixXd scalar(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

HarmonicBalance oscillator(double damping, const Joint& joint) {
  return {std::make_shared<MatrixReceptance>(MatrixStructure{scalar(1.0), scalar(damping), scalar(100.0)}, scalar(1.0),
                                             scalar(1.0), scalar(1.0)),
          {joint},
          Excitation::single(1.0),
          {.fixed = {1, 3, 5}}};
}

/// Of one mass z = 1/h is a parabola, so steps may be as wide as one likes.
TEST(PeakMode, IsThatOfALinearOscillator) {
  const HarmonicBalance balance = oscillator(0.4, {.name = "spring", .stiffness = 20.0, .damping = 0.2});
  const double natural = std::sqrt(120.0), ratio = 0.6 / (2.0 * natural);
  for (const double omega : {10.0, 10.95, 12.0}) {
    const HarmonicSolution solution = balance.solve(omega);
    ASSERT_TRUE(solution.converged);
    for (const double step : {1e-3, 0.1, 2.0}) {
      const auto mode = peak_mode(balance, solution, 0, 1, {omega - step, omega + 1.5 * step});
      ASSERT_TRUE(mode);
      EXPECT_NEAR(mode->omega, natural, 1e-8 * natural);
      EXPECT_NEAR(mode->ratio, ratio, 1e-8);
    }
    EXPECT_FALSE(peak_mode(balance, solution, 0, 3, {omega - 1.0, omega + 1.0}));  // no force of harmonic 3
  }
}

/// A slipping joint as the equivalent spring and damper of its amplitude: damping of both kinds together, to the square of it.
TEST(PeakMode, HasTheEquivalentDampingOfTheJoint) {
  const Joint joint = {.name = "slip", .friction = friction::make_element("bilinear", std::vector{0.02, 20.0})};
  const HarmonicBalance balance = oscillator(0.2, joint);
  for (const double level : {0.5, 1.0, 4.0}) {
    const HarmonicSolution solution = balance.solve(10.4, level);
    ASSERT_TRUE(solution.converged);
    const Complex factor = solution.joint_force(0, 0) / solution.joint_motion(0, 0);
    const double natural = std::sqrt(100.0 + factor.real());
    const double ratio = 0.5 * (0.2 / natural + factor.imag() / (natural * natural));
    const auto mode = peak_mode(balance, solution, 0, 1, {10.3, 10.5});
    ASSERT_TRUE(mode);
    EXPECT_NEAR(mode->omega, natural, 2.0 * ratio * ratio * natural);
    EXPECT_NEAR(mode->ratio, ratio, 3.0 * ratio * ratio);
  }
}

}  // namespace
}  // namespace jointid::response
