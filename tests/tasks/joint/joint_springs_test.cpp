#include "tasks/joint/joint_springs.hpp"

#include <gmock/gmock.h>

#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "tasks/joint_forecast.hpp"
#include "tasks/joint/run_difference.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

using frf::Dof;
using restrictions::Kind;

ident::Estimate estimate(const std::string& name, double value, double half) {
  ident::Estimate out;
  out.name = name;
  out.unit = "N/m";
  out.value = value;
  out.ci95 = {{value - half, value + half}};
  return out;
}

restrictions::Restriction springs_at(const std::vector<std::array<const char*, 2>>& ends, bool damping = false) {
  restrictions::JointSpec joint;
  std::vector<restrictions::Spring> springs;
  for (const auto& [first, second] : ends) {
    springs.push_back({Dof::parse(first), Dof::parse(second)});
    for (const char* dof : {first, second}) joint.dofs.push_back(Dof::parse(dof));
  }
  joint.matrices[Kind::stiffness] = springs;
  if (damping) joint.matrices[Kind::hysteretic_damping] = springs;
  return restrictions::build({joint});
}

ident::Solution with(const restrictions::Restriction& restriction, const std::vector<double>& values, const std::vector<double>& halves) {
  ident::Solution solution;
  for (std::size_t i = 0; i < values.size(); ++i)
    solution.unknowns.push_back(estimate(restriction.unknowns[i].name, values[i], halves[i]));
  return solution;
}

TEST(JointSprings, TheLooseOneOfItsDirectionIsTold) {
  const auto restriction = springs_at({{"1:+X", "11:+X"}, {"2:+X", "12:+X"}, {"3:+X", "13:+X"}, {"1:+Z", "11:+Z"}});
  const auto found = joint_springs(restriction, with(restriction, {1e8, 1.2e8, 2e7, 1e6}, {1e6, 1e6, 1e6, 1e5}));
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[2].tightness, Tightness::loose);
  EXPECT_NEAR(found[2].share, 0.2, 1e-12);
  EXPECT_NEAR(*found[2].share_half_width, 0.01, 1e-12);
  EXPECT_EQ(found[2].ends.front()[1].name(), "13:+X");
  EXPECT_EQ(found[0].tightness, Tightness::alike);
  EXPECT_EQ(found[3].share, 1.0);  // of another direction
}

TEST(JointSprings, AWideIntervalIsDoubtfulAndNoIntervalToo) {
  const auto restriction = springs_at({{"1:+X", "11:+X"}, {"2:+X", "12:+X"}, {"3:+X", "13:+X"}});
  ident::Solution solution = with(restriction, {1e8, 1e8, 4e7}, {1e6, 1e6, 3e7});
  EXPECT_EQ(joint_springs(restriction, solution)[2].tightness, Tightness::doubtful);
  solution.unknowns[2].ci95.reset();
  EXPECT_EQ(joint_springs(restriction, solution)[2].tightness, Tightness::doubtful);
  solution.unknowns[2].determined = false;
  EXPECT_EQ(joint_springs(restriction, solution).size(), 2U);
}

TEST(JointSprings, HaveTheLossFactorOfTheirDamping) {
  const auto restriction = springs_at({{"1:+X", "11:+X"}}, true);
  const auto found = joint_springs(restriction, with(restriction, {1e8, 5e6}, {1e6, 1e6}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(*found[0].loss_factor, 0.05, 1e-12);
}

TEST(JointSprings, FullMatricesHaveNone) {
  restrictions::JointSpec joint;
  joint.dofs = {Dof::parse("1:+X"), Dof::parse("11:+X")};
  joint.matrices[Kind::stiffness] = restrictions::Pattern::symmetric;
  const auto restriction = restrictions::build({joint});
  EXPECT_TRUE(joint_springs(restriction, with(restriction, {1e8, -1e8, 1e8}, {1e6, 1e6, 1e6})).empty());
}

TEST(RunDifferences, HaveTheIntervalOfBoth) {
  const auto found = run_differences({estimate("a", 10.0, 3.0), estimate("b", 10.0, 3.0), estimate("c", 1.0, 1.0)},
                                     {estimate("b", 16.0, 4.0), estimate("a", 14.0, 4.0)});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "a");
  EXPECT_DOUBLE_EQ(found[0].difference, 4.0);
  EXPECT_DOUBLE_EQ(*found[0].half, 5.0);
  EXPECT_FALSE(found[0].differs());
  EXPECT_TRUE(found[1].differs());
  EXPECT_DOUBLE_EQ(found[1].relative, 0.6);
  ident::Estimate other_unit = estimate("a", 14.0, 4.0);
  other_unit.unit = "mixed";
  EXPECT_TRUE(run_differences({estimate("a", 10.0, 3.0)}, {other_unit}).empty());
}

/// What is foretold of the joint of a problem beside the intervals of its solution.
void expect_near_the_intervals(const char* name) {
  const TestFolder folder;
  const ident::Scene scene = ident::read_scene(problems::write(problems::make(name), folder, {}));
  const JointForecast forecast = forecast_joint(scene);
  ASSERT_FALSE(forecast.bounds.empty()) << forecast.why;
  ident::Scene likely = scene;
  likely.identify = {};
  likely.identify.method = ident::Method::likelihood;
  likely.truth.clear();
  const auto plan = ident::make_plan(likely);
  const ident::Solution solution = ident::solve(*plan);
  ASSERT_EQ(forecast.bounds.size(), solution.unknowns.size());
  EXPECT_EQ(forecast.unknowns, solution.unknowns.size());
  for (std::size_t i = 0; i < forecast.bounds.size(); ++i) {
    ASSERT_TRUE(solution.unknowns[i].std_error);
    const double ratio = forecast.bounds[i].bound / *solution.unknowns[i].std_error;
    EXPECT_GT(ratio, 1.0 / 4.0) << forecast.bounds[i].name;
    EXPECT_LT(ratio, 4.0) << forecast.bounds[i].name;
  }
}

TEST(JointForecast, IsNearTheIntervalsOfTheSolution) { expect_near_the_intervals("rig1"); }

TEST(JointForecast, IntervalsAreSaidByTheMiddleAndTheWorst) {
  JointForecast forecast;
  EXPECT_EQ(relative_intervals(forecast), (std::array<double, 2>{}));
  forecast.bounds = {{"a", "", 10.0, 1.0, 0.1}, {"b", "", -10.0, 2.0, 0.2}, {"c", "", 10.0, std::numeric_limits<double>::infinity(), 0.0}};
  const auto [middle, worst] = relative_intervals(forecast);
  EXPECT_NEAR(middle, 0.392, 1e-3);
  EXPECT_TRUE(std::isinf(worst));
}

}  // namespace
}  // namespace jointid::tasks
