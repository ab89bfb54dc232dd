#include "ident/automatic_method.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "frf/set/frf_source.hpp"
#include "ident/identify.hpp"
#include "ident/plan/expected_time.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Case A1 with 5 % noise and a scene that leaves the method open.
class Automatic : public ::testing::Test {
 protected:
  Automatic() {
    scene.identify = {};
    scene.identify.automatic = scene.identify.any_weighting = true;
  }

  std::unique_ptr<Plan> plan() const { return problems::plan(scene, problems::polluted(problem, 1, 0)); }

  Solution solution() const { return solve(*plan(), {}); }

  Solution named(Method method, weighting::Weighting weighting) const {
    Scene other = scene;
    other.identify.automatic = false;
    other.identify.method = method;
    other.identify.weighting = weighting;
    return solve(*problems::plan(other, problems::polluted(problem, 1, 0)), {});
  }

  problems::Problem problem = problems::make("A1");
  Scene scene = problems::scene(problem);
};

std::vector<double> values(const Solution& solution) {
  std::vector<double> out;
  for (const Estimate& estimate : solution.unknowns) out.push_back(estimate.value);
  return out;
}

TEST_F(Automatic, TakesTheLikelihoodWhereVariancesAreKnown) {
  const Solution found = solution();
  EXPECT_EQ(found.used.method, Method::likelihood);
  EXPECT_THAT(found.used.chosen, StartsWith("method likelihood: the variances"));
  EXPECT_EQ(values(found), values(named(Method::likelihood, weighting::Weighting::wb)));
}

TEST_F(Automatic, TakesMethodOneWhereVariancesAreNotKnownAndTheWeightingThatPredictsBest) {
  using enum weighting::Weighting;
  scene.noise.reset();
  const Solution found = solution();
  EXPECT_EQ(found.used.method, Method::one);
  EXPECT_THAT(found.used.chosen, HasSubstr("not known"));
  double least = 1e300;
  for (const auto each : {wb, wbg, wbs, wa}) {
    const Solution one = named(Method::one, each);
    least = std::min(least, *one.fit.asm_frf_error);
    if (each == found.used.weighting) {
      EXPECT_EQ(values(found), values(one));
    }
  }
  EXPECT_EQ(*found.fit.asm_frf_error, least);
}

TEST_F(Automatic, AWeightingAsksForMethodOne) {
  scene.identify.any_weighting = false;
  scene.identify.weighting = weighting::Weighting::wa;
  const Solution found = solution();
  EXPECT_EQ(found.used.method, Method::one);
  EXPECT_EQ(found.used.weighting, weighting::Weighting::wa);
  EXPECT_THAT(found.used.chosen, HasSubstr("names a weighting"));
}

TEST_F(Automatic, ASolverAsksForTheMethodThatHasIt) {
  for (const auto& [solver, method] : {std::pair("iqml", Method::likelihood), std::pair("normal", Method::one),
                                       std::pair("levenberg-marquardt", Method::newton)}) {
    scene.identify.solver = parse_solver(solver);
    const auto planned = plan();
    EXPECT_EQ(planned->scene.identify.method, method) << solver;
    EXPECT_THAT(planned->chosen, HasSubstr(solver));
  }
}

TEST_F(Automatic, PriorsAskForTheLikelihood) {
  scene.noise.reset();
  scene.identify.priors = {{"K(1,1)", 1e6, 1e5}};
  EXPECT_EQ(plan()->scene.identify.method, Method::likelihood);
}

TEST_F(Automatic, TakesMethodOneWhereTheDataDoNotAllowTheLikelihood) {
  for (auto& [kind, spec] : scene.joints.front().matrices) spec = restrictions::Pattern::full;
  const auto planned = plan();
  EXPECT_EQ(planned->scene.identify.method, Method::one);
  EXPECT_THAT(planned->chosen, HasSubstr("reciprocal"));
}

TEST_F(Automatic, ASceneThatNamesItsMethodIsLeftAlone) {
  EXPECT_THAT(named(Method::one, weighting::Weighting::wb).used.chosen, IsEmpty());
}

TEST_F(Automatic, PlansTheCostOfWhatIterates) {
  const auto planned = plan();
  const Cost& cost = planned->cost;
  const std::size_t own_side = 6 * 2 + 4 * 2, joint = 3 + 3;  // FRFs of the parts between others and joint, at the joint
  EXPECT_EQ(cost.iteration.matrix, 2 * (own_side + joint));
  EXPECT_GT(cost.iteration.memory_bytes, cost.bytes_read);
  EXPECT_GT(expected_seconds(cost), 0.0);
  EXPECT_TRUE(are_expected_within(60.0, cost));
  Cost huge = cost;
  huge.iteration.flops *= 1e9;
  EXPECT_FALSE(are_expected_within(60.0, huge));
  scene.identify.any_weighting = false;
  EXPECT_EQ(expected_seconds(plan()->cost), 0.0);
}

/// What is planned, at so many times the flops that an iteration takes.
TEST_F(Automatic, TakesMethodOneWhereTheLikelihoodWouldTakeTooLong) {
  const auto given = plan();
  const auto chosen = [&](double times) {
    return plan_automatically(scene, *given->substructures, *given->assembly, [&](const Scene& asked) {
      auto planned = problems::plan(asked, problems::polluted(problem, 1, 0));
      planned->cost.iteration.flops *= times;
      return planned;
    });
  };
  EXPECT_EQ(chosen(1.0)->scene.identify.method, Method::likelihood);
  double times = 1.0;  // more than a minute, as a rig of many lines takes
  const auto within = [&](double seconds) {
    Cost cost = given->cost;
    cost.iteration.flops *= times;
    return are_expected_within(seconds, cost);
  };
  while (within(60.0)) times *= 1.3;
  ASSERT_TRUE(within(120.0));
  EXPECT_EQ(chosen(times)->scene.identify.method, Method::likelihood);
  while (within(120.0)) times *= 1.3;
  EXPECT_EQ(chosen(times)->scene.identify.method, Method::one);
  const auto slow = chosen(1e9);
  EXPECT_EQ(slow->scene.identify.method, Method::one);
  EXPECT_THAT(slow->chosen, HasSubstr("would take about"));
}

/// 56 s of a slow machine, half a Gflop a second: it is not measured how fast this one is.
TEST_F(Automatic, ExpectsEightFactorisationsOfALine) {
  Cost cost = plan()->cost;
  EXPECT_EQ(cost.iteration.expected, 8u);
  cost.iteration.flops = 3.5e9;
  EXPECT_TRUE(are_expected_within(60.0, cost));
}

/// The assembly of A1 without its joint.
problems::Measurement unreached(const problems::Problem& problem) {
  problems::Measurement out = problems::polluted(problem, 1, 0);
  out.assembly = problems::without(out.assembly, problem.joint_dofs);
  return out;
}

TEST_F(Automatic, NeverTakesMethodOneWhereItHasNoEquation) {
  const auto chosen = [&] { return problems::plan(scene, unreached(problem)); };
  EXPECT_EQ(chosen()->scene.identify.method, Method::likelihood);
  scene.noise.reset();
  const auto without_variances = chosen();
  EXPECT_NE(without_variances->scene.identify.method, Method::one);
  EXPECT_THAT(without_variances->chosen, HasSubstr("no equation"));
  for (auto& [kind, spec] : scene.joints.front().matrices) spec = restrictions::Pattern::full;  // no likelihood
  EXPECT_EQ(chosen()->scene.identify.method, Method::newton);
}

TEST_F(Automatic, KeepsTheLikelihoodHoweverLongWhereMethodOneHasNoEquation) {
  const auto given = problems::plan(scene, unreached(problem));
  const auto slow = plan_automatically(scene, *given->substructures, *given->assembly, [&](const Scene& asked) {
    auto planned = problems::plan(asked, unreached(problem));
    planned->cost.iteration.flops *= 1e9;
    return planned;
  });
  EXPECT_EQ(slow->scene.identify.method, Method::likelihood);
  EXPECT_THAT(slow->chosen, HasSubstr("no equation"));
}

/// Nothing is timed, so that what else the machine does makes no difference: once with a thread that takes what it can.
TEST(AutomaticUnderLoad, PlansOfTwentyScenesAreTheSame) {
  const auto plans = [] {
    std::vector<std::pair<std::string, double>> out;
    for (const char* name : {"A1", "A3", "A5", "A7", "A8", "A9", "A10", "B",  "C1", "C2",
                             "D1", "D2", "D3", "E1", "E2", "E3", "F1",  "G1", "G3", "H4"}) {
      const problems::Problem problem = problems::make(name);
      Scene scene = problems::scene(problem);
      scene.identify = {};
      scene.identify.automatic = scene.identify.any_weighting = true;
      const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
      out.emplace_back(plan->chosen, expected_seconds(plan->cost, 1));
    }
    return out;
  };
  const auto idle = plans();
  std::atomic<bool> ends = false;
  std::jthread load([&] {
    volatile double sum = 0.0;
    while (!ends) sum = sum + 1.0;
  });
  EXPECT_EQ(plans(), idle);
  ends = true;
  EXPECT_EQ(idle.size(), 20u);
}

TEST_F(Automatic, TimesOfThePhasesAddUpToTheTotal) {
  const RunTime time = solution().runtime_s;
  double sum = 0.0;
  for (const auto& [phase, seconds] : run_time_phases) {
    EXPECT_GE(time.*seconds, 0.0) << phase;
    sum += time.*seconds;
  }
  EXPECT_LE(sum, time.total);
  EXPECT_GT(sum, 0.8 * time.total);
}

}  // namespace
}  // namespace jointid::ident
