#include "study/trial_runner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::study {
namespace {

/// Trials against the long way: the whole problem polluted, planned and solved anew.
class EveryTrial : public testing::TestWithParam<const char*> {};

TEST_P(EveryTrial, IsThatOfPollutingPlanningAndSolvingAnew) {
  const problems::Problem problem = problems::make(GetParam());
  const ident::Scene scene = problems::scene(problem);
  TrialRunner runner(problems::trial_data(scene, problem));
  for (const std::uint64_t trial : {3u, 0u, 3u}) {
    const Trial quick = runner.run(11, trial);
    const auto plan = problems::plan(scene, problems::polluted(problem, 11, trial));
    const ident::Solution slow = ident::solve(*plan);
    ASSERT_EQ(quick.status, slow.status);
    ASSERT_EQ(quick.values.size(), slow.unknowns.size());
    for (std::size_t i = 0; i < quick.values.size(); ++i) EXPECT_EQ(quick.values[i], slow.unknowns[i].value);
    std::size_t judged = 0;
    for (const auto& [kind, quality] : slow.quality) EXPECT_EQ(quick.quality[judged++].rjcf, quality.rjcf);
    EXPECT_EQ(judged, quick.quality.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, EveryTrial, testing::Values("A1", "A11", "B", "A10", "rig1"));

TEST(TrialData, HoldsJustTheLinesAndDofsOfThePlan) {
  const problems::Problem problem = problems::make("A1");
  ident::Scene scene = problems::scene(problem);
  scene.identify.equations = {ident::Equation::nn};
  scene.frequency.range_hz = ident::Range{500.0, 700.0};
  const auto data = problems::trial_data(scene, problem);
  EXPECT_EQ(data->lines, 11u);
  EXPECT_EQ(data->base.assembly.front().header.lines(), 11u);
  EXPECT_EQ(data->base.assembly.front().header.response.size(), 10u);
  EXPECT_EQ(data->base.assembly.front().header.reference.size(), 14u);
}

TEST(TrialData, KnowsTheTrueValuesOfTheUnknowns) {
  for (const char* name : {"A1", "A9", "B"}) {
    const problems::Problem problem = problems::make(name);
    const auto data = problems::trial_data(problems::scene(problem), problem);
    ASSERT_EQ(data->unknowns.size(), problem.unknowns.size());
    for (std::size_t i = 0; i < data->unknowns.size(); ++i) {
      EXPECT_EQ(data->unknowns[i].name, problem.unknowns[i].name);
      ASSERT_TRUE(data->unknowns[i].truth.has_value()) << data->unknowns[i].name;
      EXPECT_NEAR(*data->unknowns[i].truth, problem.unknowns[i].value, 1e-12 * std::abs(problem.unknowns[i].value));
    }
  }
}

}  // namespace
}  // namespace jointid::study
