#include "tasks/convergence.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

std::unique_ptr<Plan> noisy_plan(const std::string& name) {
  const problems::Problem problem = problems::make(name);
  return problems::plan(problems::scene(problem), problems::polluted(problem, 1, 0));
}

TEST(Convergence, TheLastPointIsTheSolutionItself) {
  const auto plan = noisy_plan("A1");
  const auto points = tasks::quality_by_line(*plan, 1000);
  const Solution solution = solve(*plan);
  ASSERT_FALSE(points.empty());
  EXPECT_EQ(points.back().lines, plan->lines.size());
  ASSERT_FALSE(solution.quality.empty());
  for (const auto& [kind, quality] : solution.quality) {
    EXPECT_NEAR(points.back().quality.at(kind).rjcf, quality.rjcf, 1e-9);
    EXPECT_NEAR(points.back().quality.at(kind).arvf, quality.arvf, 1e-9);
  }
}

/// Each point is what the scene cut to its first lines gives.
TEST(Convergence, AnEarlierPointIsTheSolutionOfItsLines) {
  const auto plan = noisy_plan("A1");
  const auto points = tasks::quality_by_line(*plan, 1000);
  plan->lines.resize(10);
  const Solution solution = solve(*plan);
  const auto point = std::ranges::find(points, 10u, &tasks::LineQuality::lines);
  ASSERT_NE(point, points.end());
  EXPECT_EQ(point->frequency_hz, plan->lines.back().frequency_hz);
  ASSERT_FALSE(solution.quality.empty());
  for (const auto& [kind, quality] : solution.quality) EXPECT_NEAR(point->quality.at(kind).arvf, quality.arvf, 1e-9);
}

TEST(Convergence, ManyLinesGiveAsManyPointsAsAskedFor) {
  const auto plan = noisy_plan("A6");
  const auto points = tasks::quality_by_line(*plan, 20);
  EXPECT_LE(points.size(), 20U);
  EXPECT_GE(points.size(), 15U);
  EXPECT_EQ(points.back().lines, plan->lines.size());
}

/// Together as the scene cut to its first lines, alone as the scene cut to that line; a truth is not needed.
TEST(Convergence, UnknownsFollowTheLinesTogetherAndAlone) {
  const auto plan = noisy_plan("A1");
  plan->scene.truth.clear();
  const tasks::UnknownsByLine found = tasks::unknowns_by_line(*plan, 1000);
  const auto all = plan->lines;
  const auto expect_values = [](const std::vector<double>& values, const Solution& solution) {
    ASSERT_EQ(values.size(), solution.unknowns.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], solution.unknowns[i].value, 1e-9 * std::abs(solution.unknowns[i].value) + 1e-6);
    }
  };
  const auto point = std::ranges::find(found.lines, 10u, &tasks::LineUnknowns::lines);
  ASSERT_NE(point, found.lines.end());
  EXPECT_EQ(found.lines.back().lines, all.size());
  plan->lines.assign(all.begin(), all.begin() + 10);
  expect_values(point->together, solve(*plan));
  plan->lines.assign(all.begin() + 9, all.begin() + 10);
  expect_values(point->alone, solve(*plan));
}

TEST(Convergence, UnknownsOfOtherMethodsFollowNoLines) {
  const auto plan = noisy_plan("H4");
  EXPECT_THROW(tasks::unknowns_by_line(*plan, 10), InputError);
}

TEST(Convergence, ObjectiveFallsOverTheIterationsToTheSolution) {
  for (const std::string name : {"H4", "A1"}) {
    const problems::Problem problem = problems::make(name);
    Scene scene = problems::scene(problem);
    if (name == "A1") scene.identify.method = Method::likelihood;
    const auto plan = problems::plan(scene, problems::polluted(problem, 1, 0));
    const tasks::UnknownsByIteration found = tasks::unknowns_by_iteration(*plan);
    const Solution solution = solve(*plan);
    ASSERT_GE(found.iterations.size(), 2U) << name;
    for (std::size_t i = 1; i < found.iterations.size(); ++i) {
      EXPECT_GT(found.iterations[i].iteration, found.iterations[i - 1].iteration) << name;
      if (!found.iterations[i].objective || !found.iterations[i - 1].objective) continue;
      EXPECT_LE(*found.iterations[i].objective, *found.iterations[i - 1].objective) << name;
    }
    ASSERT_EQ(found.names.size(), solution.unknowns.size()) << name;
    for (std::size_t u = 0; u < found.names.size(); ++u) {
      const Estimate& estimate = solution.unknowns[u];
      EXPECT_EQ(found.names[u], estimate.name);
      EXPECT_NEAR(found.iterations.back().values[u], estimate.value, 1e-9 * std::abs(estimate.value)) << name << ' ' << estimate.name;
    }
  }
}

TEST(Convergence, LinearMethodsDoNotIterate) { EXPECT_THROW(tasks::unknowns_by_iteration(*noisy_plan("A1")), InputError); }

TEST(Convergence, WithoutATruthThereIsNone) {
  const auto plan = noisy_plan("A1");
  plan->scene.truth.clear();
  EXPECT_TRUE(tasks::quality_by_line(*plan, 10).empty());
}

}  // namespace
}  // namespace jointid::ident
