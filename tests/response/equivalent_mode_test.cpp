#include "response/equivalent/equivalent_mode.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "response/fourier/joint_force.hpp"
#include "tests/require.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

TEST(EquivalentMode, MeetsTheGoldenValues) {
  const auto cases = golden::cases("equivalent_mode");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const double tolerance = golden::tolerance(each["trusted_digits"]);
    for (const auto& expected : each["values"]) {
      const EquivalentMode found = equivalent_mode(golden::structure(each), golden::matrix(each["W"]),
                                                   golden::joints(each["joints"]), 1, 0, expected["joint_amplitude"]);
      const auto near = [&](double value, const char* name, double size) {
        EXPECT_NEAR(value, expected[name].get<double>(), tolerance * size) << name;
      };
      EXPECT_TRUE(found.converged);
      near(found.joints[0].stiffness, "k_e", 150.0);
      near(found.joints[0].damping, "d_e", 150.0);
      near(found.omega, "omega_2", found.omega);
      near(found.loss_factor_joints, "loss_factor_joint", 1.0);
      near(found.loss_factor_viscous, "loss_factor_viscous", 1.0);
      near(std::abs(found.motion(0)), "coordinate_1_amplitude", std::abs(found.motion(0)));
    }
  }
}

/// k_e + id_e is the first harmonic of the event-exact integrals over the motion.
TEST(EquivalentMode, JointIsTheFirstHarmonic) {
  const Joint joint = {.name = "joint",
                       .friction = friction::make_element("iwan", std::vector{0.6, 2.0, -0.4, 0.3}),
                       .stiffness = 0.5,
                       .damping = 0.02,
                       .cubic = 0.3};
  for (const double amplitude : {0.01, 0.3, 2.0}) {
    const Harmonics one({1});
    const Complex ratio =
        JointForce(joint).evaluate({one, Eigen::VectorXcd::Constant(1, amplitude)}, 3.0, one).force(0) / amplitude;
    const EquivalentJoint found = equivalent_joint(joint, amplitude, 3.0);
    EXPECT_NEAR(found.stiffness, ratio.real(), 1e-12 * std::abs(ratio));
    EXPECT_NEAR(found.damping, ratio.imag(), 1e-12 * std::abs(ratio));
  }
}

TEST(EquivalentMode, SaysWhatDoesNotExist) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  const std::vector<Joint> joints = {{.name = "joint", .stiffness = 1.0}};
  EXPECT_THROW(equivalent_mode({one, one, one}, one, joints, 1, 0, 1.0), InputError);
  EXPECT_THROW(equivalent_mode({one, one, one}, one, joints, 0, 0, 0.0), InputError);
  EXPECT_THROW(equivalent_mode({one, one, one}, 0.0 * one, joints, 0, 0, 1.0), InputError);
}

}  // namespace
}  // namespace jointid::response
