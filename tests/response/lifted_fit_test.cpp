#include "response/identify/lifted_fit.hpp"

#include <gtest/gtest.h>

#include "tests/response/measured_masses.hpp"

namespace jointid::response {
namespace {

const std::vector<Joint> truth = {{.name = "a", .friction = law("bilinear", {0.006, 200.0})},
                                  {.name = "b", .friction = law("ren", {0.004, 1.5, 150.0})}};
const std::vector<Joint> start = {{.name = "a", .friction = law("bilinear", {0.009, 150.0})},
                                  {.name = "b", .friction = law("ren", {0.003, 1.0, 220.0})}};

/// Exact data: the forces meet the law, and the numbers are the truth up to what the last tolerance leaves.
TEST(LiftedFit, FindsTheTruthWithoutNoise) {
  const auto states = measure(masses(2), truth, {1.0, 3.0, 8.0, 16.0}, {18.4, 19.6, 20.8});
  ASSERT_FALSE(states.empty());
  const LawUnknowns unknowns(start);
  const auto found = fit_lifted(masses(2), states, unknowns, {1, 3, 5});
  ASSERT_TRUE(found);
  EXPECT_LT((found->numbers - LawUnknowns(truth).start()).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT(found->chi_square, 1e-3);
  ASSERT_EQ(found->states.size(), states.size());
  const HarmonicSolution exact = HarmonicBalance(masses(2), truth, states[5].force, {.fixed = {1, 3, 5}}).solve(states[5].omega);
  EXPECT_LT((found->states[5].solution.joint_motion - exact.joint_motion).cwiseAbs().maxCoeff(),
            1e-3 * exact.joint_motion.cwiseAbs().maxCoeff());
}

/// From the minimum with harmonics 1 and 3 to that with 5, without a start from the direct step.
TEST(LiftedFit, GoesOnWithMoreHarmonics) {
  const auto states = measure(masses(2), truth, {1.0, 3.0, 8.0, 16.0}, {18.4, 19.6, 20.8});
  const LawUnknowns unknowns(start);
  const auto few = fit_lifted(masses(2), states, unknowns, {1, 3});
  ASSERT_TRUE(few);
  const auto more = fit_lifted(masses(2), states, unknowns, {1, 3, 5}, *few);
  ASSERT_TRUE(more);
  EXPECT_LT(more->chi_square, 0.1 * few->chi_square);
  EXPECT_LT((more->numbers - LawUnknowns(truth).start()).cwiseAbs().maxCoeff(), 1e-3);
}

/// One response for two joints: the direct step cannot tell their forces apart.
TEST(LiftedFit, NeedsADirectStep) {
  const auto states = measure(masses(1), {truth[0]}, {3.0}, {19.0});
  std::vector<MeasuredState> one = states;
  Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), k(3, 3), w(3, 2);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 0.0, 1.0, 0.0, -1.0, 1.0;
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(3, 3);
  const auto structure = std::make_shared<MatrixReceptance>(MatrixStructure{m, 1e-3 * k, k}, w, all.leftCols(1), all.leftCols(1));
  for (MeasuredState& state : one) {
    state.response = states[0].response.leftCols(1);
    state.deviation = states[0].deviation.leftCols(1);
  }
  EXPECT_FALSE(fit_lifted(structure, one, LawUnknowns(truth), {1, 3}));
}

}  // namespace
}  // namespace jointid::response
