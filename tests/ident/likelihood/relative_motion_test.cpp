#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ident/identify.hpp"
#include "ident/judgement/relative_motion.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"

namespace jointid::ident {
namespace {

/// Four beams in a row, 1 % noise; the second of three joints `stiffer` times as stiff.
problems::Problem row_of_beams(double stiffer) {
  problems::ManyJoints structure = problems::chain_of_beams({.joints = 3, .spacing = 1});
  for (auto& row : structure.joints[1].relative_stiffness) {
    for (double& element : row) element *= stiffer;
  }
  return problems::many_joints_problem(structure, {"row", ""}, false);
}

Scene scene_with(const problems::Problem& problem, Method method) {
  Scene scene = problems::scene(problem);
  const frf::NoiseModel& noise = std::get<frf::NoiseModel>(problem.noise);
  scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify.method = method;
  if (method == Method::likelihood) scene.identify.solver = Solver::by_parts;
  return scene;
}

TEST(RelativeMotions, OfAStiffJointAreBelowTheirErrors) {
  const problems::Problem problem = row_of_beams(1e5);
  const auto plan = problems::plan(scene_with(problem, Method::one), problems::polluted(problem, 1, 0));
  const std::vector<RelativeMotion> found = relative_motions(*plan);
  ASSERT_EQ(found.size(), 6u);
  for (const RelativeMotion& each : found) {
    EXPECT_EQ(each.a.direction, each.b.direction);
    EXPECT_TRUE(each.joint == "j2" ? each.over_error < 3.0 : each.over_error > 3.0) << each.joint << ' ' << each.over_error;
  }
}

TEST(RelativeMotions, BothWaysByPartsSayWhereTheyAreHidden) {
  Control control;
  control.judgement = Judgement::data;
  for (const Method method : {Method::one, Method::likelihood}) {
    const problems::Problem stiff = row_of_beams(100.0), usual = row_of_beams(1.0);
    const Solution hidden = solve(*problems::plan(scene_with(stiff, method), problems::polluted(stiff, 1, 0)), control);
    EXPECT_THAT(hidden.warnings, testing::Contains(testing::AllOf(testing::HasSubstr("1 of 6 pairs"), testing::HasSubstr("of j2"))));
    EXPECT_EQ(hidden.relative_motions.size(), 6u);
    const Solution seen = solve(*problems::plan(scene_with(usual, method), problems::polluted(usual, 1, 0)), control);
    EXPECT_THAT(seen.warnings, testing::Not(testing::Contains(testing::HasSubstr("move as one"))));
  }
}

/// The sum of all conditions is rounded by the stiff joint's balances: by more than the last steps gain.
TEST(RelativeMotions, AStiffJointLeavesTheOthersTheirIntervals) {
  Control control;
  control.judgement = Judgement::data;
  const problems::ManyJoints structure = problems::chain_of_beams({.joints = 3, .spacing = 1});
  const problems::Problem problem = row_of_beams(1e3);
  const Solution found = solve(*problems::plan(scene_with(problem, Method::likelihood), problems::polluted(problem, 1, 0)), control);
  EXPECT_EQ(found.status, Status::doubtful) << found.message;
  EXPECT_THAT(found.message, testing::HasSubstr("no valid digit"));
  EXPECT_THAT(found.message, testing::HasSubstr("j2.K"));
  for (const Estimate& each : found.unknowns) {
    ASSERT_TRUE(each.std_error) << each.name;
    if (each.name.starts_with("j2") || each.name[3] != 'K') continue;
    const auto& stiffness = structure.joints[each.name.starts_with("j1") ? 0 : 2].relative_stiffness;
    const double truth = each.name.ends_with('a') ? stiffness[0][0] : each.name.ends_with('b') ? stiffness[0][1] : stiffness[1][1];
    EXPECT_LT(std::abs(each.value - truth), 4.0 * *each.std_error) << each.name << ' ' << each.value << ' ' << truth;
  }
}

TEST(RelativeMotions, AreNotComparedWithErrorsThatNobodyStates) {
  const problems::Problem problem = row_of_beams(1e5);
  Scene scene = scene_with(problem, Method::one);
  scene.noise.reset();
  EXPECT_TRUE(relative_motions(*problems::plan(scene, problems::polluted(problem, 1, 0))).empty());
}

}  // namespace
}  // namespace jointid::ident
