#include "study/comparison.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::study {
namespace {

using restrictions::Kind;
using testing::HasSubstr;
using weighting::Weighting;

const std::vector<ident::Equation> nn_nj = {ident::Equation::nn, ident::Equation::nj};

/// compare() on a built-in problem.
Comparison compared(const std::string& name, const std::vector<Way>& ways, const TrialOptions& options) {
  const problems::Problem problem = problems::make(name);
  const auto source = [&](const ident::Scene& scene) { return problems::trial_data(scene, problem); };
  return compare(problems::scene(problem), ways, source, options);
}

Combination made_up(double error, double time) {
  Combination out;
  out.matrices.push_back({.rms_relative_error = {error, error, error}});
  out.solve_s = time;
  return out;
}

TEST(Spread, OfOneToTwentyOneByHand) {
  std::vector<double> values(21);
  std::iota(values.rbegin(), values.rend(), 1.0);
  const Spread found = spread(values);
  EXPECT_DOUBLE_EQ(found.low, 2.0);
  EXPECT_DOUBLE_EQ(found.median, 11.0);
  EXPECT_DOUBLE_EQ(found.high, 20.0);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
}

TEST(Spread, LeavesOutWhatIsNoNumber) {
  EXPECT_DOUBLE_EQ(spread({NAN, 3.0, NAN}).median, 3.0);
  EXPECT_TRUE(std::isnan(spread({NAN}).median));
}

TEST(Combinations, AreTheProductAndFallBackToTheScene) {
  ident::IdentifySection own;
  own.equations = nn_nj;
  own.solver = ident::Solver::qr;
  const auto ways = combinations(own, {.methods = {ident::Method::one, ident::Method::two}, .equations = {}, .weightings = {},
                                       .deltas = {0.0, 0.1}, .solvers = {}});
  ASSERT_EQ(ways.size(), 4u);
  EXPECT_EQ(ways[1].equations, nn_nj);
  EXPECT_EQ(ways[1].delta, 0.1);
  EXPECT_EQ(ways[1].solver, ident::Solver::qr);
  EXPECT_EQ(ways[2].method, ident::Method::two);
  EXPECT_TRUE(ways[2].equations.empty()) << "the scene's equations are those of method one";
}

TEST(Fronts, ByHand) {
  std::vector<Combination> all = {made_up(0.1, 3.0), made_up(0.2, 1.0), made_up(0.2, 2.0), made_up(0.3, 1.0),
                                  made_up(0.1, 3.0), made_up(NAN, 0.5)};
  mark_fronts(all);
  std::vector<bool> marks;
  for (const Combination& each : all) marks.push_back(each.matrices.front().on_front);
  EXPECT_THAT(marks, testing::ElementsAre(true, true, false, false, true, false));
}

TEST(Comparison, IsThatOfSolvingTrialAfterTrial) {
  const Way way{ident::Method::one, nn_nj, Weighting::wbs, 0.05, ident::Solver::qr};
  const Combination found = compared("A1", {way}, {.trials = 21, .seed = 3}).combinations.at(0);

  const problems::Problem problem = problems::make("A1");
  ident::Scene scene = problems::scene(problem);
  scene.identify.weighting = way.weighting;
  scene.identify.delta = way.delta;
  std::vector<double> rjcf, error, mean(20, 0.0);
  for (std::uint64_t trial = 0; trial < 21; ++trial) {
    const ident::Solution solution = ident::solve(*problems::plan(scene, problems::polluted(problem, 3, trial)));
    rjcf.push_back(solution.quality.at(Kind::hysteretic_damping).rjcf);
    error.push_back(solution.quality.at(Kind::stiffness).rms_relative_error);
    for (std::size_t i = 0; i < 20; ++i) mean[i] += solution.unknowns[i].value / problem.unknowns[i].value / 21.0;
  }
  std::ranges::sort(rjcf);
  std::ranges::sort(error);
  double bias = 0.0;
  for (std::size_t i = 0; i < 10; ++i) bias += (mean[i] - 1.0) * (mean[i] - 1.0) / 10.0;

  ASSERT_EQ(found.matrices.size(), 2u);
  EXPECT_DOUBLE_EQ(found.matrices[0].rms_relative_error.median, error[10]);
  EXPECT_DOUBLE_EQ(found.matrices[1].rjcf.low, rjcf[1]);
  EXPECT_DOUBLE_EQ(found.matrices[1].rjcf.high, rjcf[19]);
  EXPECT_NEAR(found.matrices[0].bias, std::sqrt(bias), 1e-12);
  EXPECT_EQ(found.statuses.at(ident::Status::ok), 21u);
  EXPECT_GT(found.solve_s, 0.0);
  EXPECT_GE(found.accumulator_bytes, 21u * 21u * sizeof(double));
}

TEST(Comparison, SameNumbersForAnyNumberOfThreads) {
  const std::vector<Way> ways = {{ident::Method::one, nn_nj, Weighting::wa, 0.0, ident::Solver::qr},
                                 {ident::Method::two, {ident::Equation::jn}, Weighting::wb, 0.0, ident::Solver::normal}};
  const Comparison one = compared("A1", ways, {.trials = 30, .threads = 1});
  const Comparison two = compared("A1", ways, {.trials = 30, .threads = 2});
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t m = 0; m < 2; ++m) {
      const MatrixFigures &a = one.combinations[i].matrices[m], &b = two.combinations[i].matrices[m];
      EXPECT_EQ(a.arvf.median, b.arvf.median);
      EXPECT_EQ(a.rms_relative_error.high, b.rms_relative_error.high);
      EXPECT_EQ(a.bias, b.bias);
    }
  }
}

TEST(Comparison, EveryWayHasTheSameErrors) {
  const Way way{ident::Method::one, nn_nj, Weighting::wb, 0.0, ident::Solver::qr};
  const Way few{ident::Method::one, {ident::Equation::nn}, Weighting::wb, 0.0, ident::Solver::qr};
  const Comparison found = compared("A1", {way, few, way}, {.trials = 5});
  EXPECT_EQ(found.combinations[0].matrices[0].arvf.low, found.combinations[2].matrices[0].arvf.low);
  EXPECT_NE(found.combinations[0].matrices[0].arvf.low, found.combinations[1].matrices[0].arvf.low);
}

TEST(Comparison, LeavesOutWhatCannotBe) {
  const Comparison found = compared("A1", {{ident::Method::two, {ident::Equation::nn}, Weighting::wb, 0.0, ident::Solver::qr},
                                           {ident::Method::one, {}, Weighting::wb, 0.0, ident::Solver::automatic}},
                                    {.trials = 2});
  ASSERT_EQ(found.left_out.size(), 1u);
  EXPECT_EQ(found.left_out[0].way.method, ident::Method::two);
  ASSERT_EQ(found.combinations.size(), 1u);
  EXPECT_EQ(found.combinations[0].way.equations.size(), 4u) << "all that the data allow";
  EXPECT_EQ(found.combinations[0].way.solver, ident::Solver::qr);
  EXPECT_THROW(compared("A1", {{ident::Method::two, {ident::Equation::nn}, Weighting::wb, 0.0, ident::Solver::qr}}, {.trials = 2}),
               InputError);
}

TEST(Comparison, NeedsATruth) {
  const problems::Problem problem = problems::make("A1");
  ident::Scene scene = problems::scene(problem);
  scene.truth.clear();
  const auto source = [&](const ident::Scene& each) { return problems::trial_data(each, problem); };
  try {
    compare(scene, {{}}, source, {.trials = 2});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("[truth]"));
    EXPECT_FALSE(error.parts().remedy.empty());
  }
}

TEST(Comparison, EndsWhenAsked) {
  int asked = 0;
  const TrialOptions options{.trials = 1000, .threads = 1, .progress = {}, .interrupted = [&] { return ++asked > 3; }};
  EXPECT_THROW(compared("A1", {{ident::Method::one, nn_nj, Weighting::wb, 0.0, ident::Solver::qr}}, options), Interrupted);
}

}  // namespace
}  // namespace jointid::study
