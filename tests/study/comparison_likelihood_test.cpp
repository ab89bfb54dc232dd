#include <gmock/gmock.h>

#include "base/error.hpp"
#include "study/comparison.hpp"
#include "minimise/least_squares.hpp"
#include "tests/ident/likelihood/solver_case.hpp"

namespace jointid::study {
namespace {

using testing::HasSubstr;
using weighting::Weighting;

Comparison compared(const ident::SolverCase& example, const Alternatives& alternatives, std::uint64_t trials) {
  const auto source = [&](const ident::Scene& scene) { return problems::trial_data(scene, example.problem); };
  return compare(example.scene, combinations(example.scene.identify, alternatives), source, {.trials = trials, .threads = 1});
}

TEST(CombinationsOfLikelihood, HaveNoWeightingsAndNoDeltas) {
  ident::IdentifySection own;
  const auto ways = combinations(own, {.methods = {ident::Method::one, ident::Method::likelihood},
                                       .equations = {},
                                       .weightings = {Weighting::wa, Weighting::wbs},
                                       .deltas = {0.0, 0.1, 0.2},
                                       .solvers = {ident::Solver::automatic, ident::Solver::iqml}});
  EXPECT_EQ(ways.size(), 2u * 2u * 3u + 2u);
}

TEST(ComparisonOfLikelihood, HasRowsForItsSolversAndLeavesTheRestOut) {
  const ident::SolverCase example("A1", 0.01);
  const Comparison found = compared(example, {.methods = {ident::Method::one, ident::Method::likelihood},
                                              .equations = {{ident::Equation::nn, ident::Equation::nj}},
                                              .weightings = {Weighting::wb},
                                              .deltas = {0.0, 0.1},
                                              .solvers = {ident::Solver::automatic, ident::Solver::iqml, ident::Solver::qr}},
                                    5);
  std::vector<std::string> rows;
  for (const Combination& each : found.combinations) rows.push_back(name(each.way.method) + " " + name(each.way.solver));
  EXPECT_THAT(rows, testing::ElementsAre("one qr", "one qr", "one qr", "one qr", "likelihood gauss-helmert", "likelihood iqml"));
  ASSERT_EQ(found.left_out.size(), 3u);
  EXPECT_THAT(found.left_out[0].reason, HasSubstr("method \"one\" has no solver \"iqml\""));
  EXPECT_THAT(found.left_out[2].reason, HasSubstr("method \"likelihood\" has no solver \"qr\""));
  const Combination &linear = found.combinations[0], &likelihood = found.combinations[4], &iqml = found.combinations[5];
  EXPECT_LT(likelihood.matrices[0].rms_relative_error.median, 0.5 * linear.matrices[0].rms_relative_error.median);
  EXPECT_LT(iqml.matrices[0].rms_relative_error.median, 0.7 * linear.matrices[0].rms_relative_error.median);
  EXPECT_GT(likelihood.accumulator_bytes, 31u * 1000u);
  EXPECT_EQ(likelihood.statuses.at(ident::Status::ok), 5u);
}

TEST(ComparisonOfLikelihood, HasCeresOrSaysThatTheBuildLacksIt) {
  const ident::SolverCase example("A1", 0.01);
  const Comparison found = compared(example, {.methods = {},
                                              .equations = {},
                                              .weightings = {},
                                              .deltas = {},
                                              .solvers = {ident::Solver::automatic, ident::Solver::ceres}},
                                    2);
  if (minimise::has_ceres()) {
    ASSERT_EQ(found.combinations.size(), 2u);
    EXPECT_NEAR(found.combinations[1].matrices[0].arvf.median, found.combinations[0].matrices[0].arvf.median, 1e-4);
  } else {
    ASSERT_EQ(found.left_out.size(), 1u);
    EXPECT_THAT(found.left_out[0].reason, HasSubstr("this build lacks Ceres"));
  }
}

}  // namespace
}  // namespace jointid::study
