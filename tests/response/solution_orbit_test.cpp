#include "response/stability/solution_orbit.hpp"

#include <gtest/gtest.h>

#include "friction/law/laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

std::shared_ptr<const friction::Element> law(const std::string& name, const std::vector<double>& values) {
  return friction::make_element(name, values);
}

/// Three masses with joints between the last two and from the last to ground.
MatrixAssembly assembly(const std::vector<Joint>& joints) {
  const Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), all = Eigen::MatrixXd::Identity(3, 3);
  Eigen::MatrixXd k(3, 3), w(3, 2);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 0.0, 1.0, 0.0, -1.0, 1.0;
  return {{m, 2e-3 * k, k}, w.leftCols(at(joints.size())), joints, all.leftCols(1)};
}

HarmonicSolution solution_of(const MatrixAssembly& all, const Excitation& force, double omega, std::vector<int> harmonics) {
  const auto receptance = std::make_shared<MatrixReceptance>(all.structure, all.w, Eigen::MatrixXd::Identity(3, 3), all.forces);
  return HarmonicBalance(receptance, all.joints, force, {.fixed = std::move(harmonics)}).solve(omega);
}

std::vector<int> odd(int largest) { return Harmonics::odd(largest).numbers(); }

TEST(SolutionOrbit, IsFoundFromManyHarmonicsInFewSteps) {
  const std::vector<std::vector<Joint>> cases = {
      {{.name = "slider", .friction = law("bilinear", {0.01, 150.0})}},
      {{.name = "ren", .friction = law("ren", {0.004, 1.5, 150.0})},
       {.name = "slider", .friction = law("bilinear", {0.012, 80.0})}},
      {{.name = "iwan", .friction = law("iwan", {1.5, 150.0, -0.5, 0.3}), .stiffness = 30.0, .damping = 0.1}},
  };
  const Excitation force = Excitation::single(Complex(0.0, -15.0));
  for (const auto& joints : cases) {
    const MatrixAssembly all = assembly(joints);
    const HarmonicSolution solution = solution_of(all, force, 14.0, odd(41));
    ASSERT_TRUE(solution.converged);
    const SolutionStability found = stability(all, force, solution);
    ASSERT_TRUE(found.orbit.closed) << joints[0].name;
    EXPECT_LT(found.difference, 1e-3) << joints[0].name;
    EXPECT_LE(found.orbit.periods, 8) << joints[0].name;
    EXPECT_TRUE(found.orbit.stable);
    // From rest the same orbit and the same multipliers.
    const PeriodicOrbit from_rest = find_orbit(periodic_problem(all, force, 14.0, 1.0));
    ASSERT_TRUE(from_rest.closed);
    EXPECT_LE((from_rest.x - found.orbit.x).cwiseAbs().maxCoeff(), 1e-9 * from_rest.x.cwiseAbs().maxCoeff());
    EXPECT_NEAR(std::abs(from_rest.multipliers[0]), std::abs(found.orbit.multipliers[0]), 1e-6);
  }
}

TEST(SolutionOrbit, NamesJointsWithFreeResidualForce) {
  const MatrixAssembly all = assembly({
      {.name = "slips", .friction = law("bilinear", {0.01, 150.0})},
      {.name = "spring", .stiffness = 10.0},
  });
  const MatrixAssembly stiff = assembly({{.name = "slips", .friction = law("bilinear", {0.01, 150.0})},
                                         {.name = "sticks", .friction = law("bilinear", {10.0, 80.0})}});
  const Excitation force = Excitation::single(400.0);
  EXPECT_TRUE(stability(all, force, solution_of(all, force, 14.0, odd(21))).residual_force_free.empty());
  const SolutionStability found = stability(stiff, force, solution_of(stiff, force, 14.0, odd(21)));
  EXPECT_EQ(found.residual_force_free, (std::vector<std::size_t>{1}));
  EXPECT_NEAR(std::abs(found.orbit.multipliers[0]), 1.0, 1e-8);
}

TEST(SolutionOrbit, SpringsOfJointsAreThoseOfTheStructure) {
  const auto slider = law("bilinear", {0.01, 150.0});
  const MatrixAssembly beside = assembly({{.name = "both", .friction = slider, .stiffness = 40.0, .damping = 0.2}});
  MatrixAssembly inside = assembly({{.name = "slider", .friction = slider}});
  inside.structure.stiffness += 40.0 * inside.w * inside.w.transpose();
  inside.structure.damping += 0.2 * inside.w * inside.w.transpose();
  const Excitation force = Excitation::single(15.0);
  const SolutionStability a = stability(beside, force, solution_of(beside, force, 14.0, odd(9)));
  const SolutionStability b = stability(inside, force, solution_of(inside, force, 14.0, odd(9)));
  ASSERT_TRUE(a.orbit.closed);
  EXPECT_LE((a.orbit.x - b.orbit.x).cwiseAbs().maxCoeff(), 1e-10 * b.orbit.x.cwiseAbs().maxCoeff());
}

/// A spring that pushes away more than the structure holds: harmonic balance has a solution, which no motion is near.
TEST(SolutionOrbit, AMotionThatRunsAwayHasNone) {
  const MatrixAssembly all =
      assembly({{.name = "away", .friction = law("bilinear", {0.01, 1e-9}), .stiffness = -4000.0}});
  const Excitation force = Excitation::single(1e4);
  const HarmonicSolution solution = solution_of(all, force, 14.0, odd(5));
  ASSERT_TRUE(solution.converged);
  EXPECT_FALSE(stability(all, force, solution).orbit.closed);
}

}  // namespace
}  // namespace jointid::response
