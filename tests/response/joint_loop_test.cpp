#include "response/fourier/joint_loop.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "friction/law/laws.hpp"
#include "response/fourier/joint_force.hpp"

namespace jointid::response {
namespace {

std::vector<Joint> joints() {
  std::vector<Joint> all;
  const auto add = [&](const std::string& law, const std::vector<double>& values) {
    all.push_back({.name = law, .friction = friction::make_element(law, values)});
  };
  add("bilinear", {0.01, 150.0});
  add("ren", {0.004, 1.5, 150.0});
  add("shoukry", {1.5, 100.0});
  add("iwan", {1.5, 150.0, -0.5, 0.3});
  all.push_back({.name = "springs", .friction = all[0].friction, .stiffness = 20.0, .damping = 0.3, .cubic = 1e4});
  all.push_back({.name = "no friction", .stiffness = 20.0, .damping = 0.3});
  return all;
}

std::vector<Motion> motions() {
  const Eigen::Vector2cd odd(Complex(0.012, -0.007), Complex(-0.006, 0.005));
  const Eigen::Vector3cd even(0.003, Complex(0.015, 0.004), Complex(0.004, 0.009));
  return {Motion(Harmonics({1, 3}), odd), Motion(Harmonics({0, 1, 2}), even),
          Motion(Harmonics({1}), Eigen::VectorXcd::Constant(1, 0.02))};
}

/// Sums over even samples are Fourier integrals to the order of the kinks, 1/points².
TEST(JointLoop, HasTheHarmonicsOfTheForce) {
  constexpr double omega = 3.0;
  constexpr int points = 4096;
  for (const Joint& joint : joints()) {
    for (const Motion& motion : motions()) {
      const JointLoop loop = joint_loop(joint, motion, omega, points);
      const Harmonics wanted = Harmonics::all(5);
      const Eigen::VectorXcd exact = JointForce(joint).evaluate(motion, omega, wanted).force;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        Complex sum = 0.0;
        for (int k = 0; k < points; ++k) sum += loop.force(k) * std::polar(1.0, -2.0 * std::numbers::pi * wanted[i] * k / points);
        sum *= (wanted[i] == 0 ? 1.0 : 2.0) / points;
        EXPECT_LE(std::abs(sum - exact(i)), 2e-5 * exact.cwiseAbs().maxCoeff()) << joint.name << " " << wanted[i];
      }
    }
  }
}

TEST(JointLoop, BeginsWhereTheMemoryEnds) {
  for (const Joint& joint : joints()) {
    if (!joint.friction || joint.stiffness != 0.0) continue;
    for (const Motion& motion : motions()) {
      const PeriodicMemory memory = periodic_memory(*joint.friction, motion);
      EXPECT_NEAR(memory.force, joint_loop(joint, motion, 1.0, 64).force(0), 1e-12 * 150.0 * 0.02) << joint.name;
      ASSERT_FALSE(memory.turns.empty());
      for (const double turn : memory.turns) EXPECT_LE(std::abs(turn), std::abs(memory.turns.front()) * (1.0 + 1e-12));
    }
  }
}

TEST(JointLoop, WithoutMotionThereIsNoForce) {
  const Motion rest(Harmonics({1, 3}), Eigen::VectorXcd::Zero(2));
  for (const Joint& joint : joints()) EXPECT_TRUE(joint_loop(joint, rest, 1.0, 16).force.isZero(0.0)) << joint.name;
  EXPECT_TRUE(periodic_memory(*joints()[0].friction, rest).turns.empty());
}

}  // namespace
}  // namespace jointid::response
