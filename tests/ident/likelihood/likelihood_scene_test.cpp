#include <gmock/gmock.h>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "tests/ident/likelihood_accuracy.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;
using enum Equation;

/// Largest error of an unknown in its bounds of the problem's noise.
double largest_error(const Solution& solution, const std::vector<double>& truth) {
  double largest = 0.0;
  for (std::size_t u = 0; u < truth.size(); ++u) {
    largest = std::max(largest, std::abs(solution.unknowns[u].value - truth[u]) / *solution.unknowns[u].std_error);
  }
  return largest;
}

Solution solve_noisy(const LikelihoodCase& run) {
  return solve(*problems::plan(run.scene, problems::polluted(run.problem, 5, 0)));
}

class EveryChoice : public testing::TestWithParam<std::vector<Equation>> {};

TEST_P(EveryChoice, OfEquationsGivesTheJoint) {
  LikelihoodCase a1("A1", GetParam());
  const Solution solution = solve_noisy(a1.at(0.01));
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  EXPECT_LT(largest_error(solution, a1.truth), 5.0);
  const ChiSquare& chi_square = *solution.fit.chi_square;
  EXPECT_NEAR(chi_square.value / chi_square.degrees_of_freedom, 1.0, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Likelihood, EveryChoice,
                         testing::Values(std::vector{nn}, std::vector{nj}, std::vector{nn, nj}, std::vector{jj},
                                         std::vector{nn, nj, jj, jn}, std::vector<Equation>{}));

TEST(LikelihoodScene, ReadsHnnAloneFromTheStartOfTheScene) {
  LikelihoodCase h4("H4", {nn});
  const Solution solution = solve_noisy(h4.at(0.01));
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  EXPECT_LT(largest_error(solution, h4.truth), 5.0);
}

/// Starts are told apart by some lines, and these are taken from those that are measured.
TEST(LikelihoodScene, LinesThatAreNotMeasuredAreNone) {
  LikelihoodCase a1("A1");
  a1.at(0.05);
  problems::Measurement noisy = problems::polluted(a1.problem, 5, 0);
  const frf::FrfHeader& header = noisy.assembly.header;
  const std::size_t entries = header.response.size() * header.reference.size();
  for (std::size_t line = 0; line < header.lines(); ++line) {
    if (line % 3 > 0) continue;
    const double f = header.frequency_hz[line];
    a1.scene.frequency.exclude_hz.push_back({f - 1e-3, f + 1e-3});
  }
  const Solution without = solve(*problems::plan(a1.scene, noisy));
  a1.scene.frequency.exclude_hz.clear();
  for (std::size_t line = 0; line < header.lines(); ++line) {
    if (line % 3 == 0) std::fill_n(noisy.assembly.values.begin() + std::ptrdiff_t(line * entries), entries, Complex(nan, nan));
  }
  const Solution unmeasured = solve(*problems::plan(a1.scene, noisy));
  EXPECT_EQ(unmeasured.status, without.status) << unmeasured.message;
  for (std::size_t u = 0; u < without.unknowns.size(); ++u)
    EXPECT_NEAR(unmeasured.unknowns[u].value, without.unknowns[u].value, 0.01 * *without.unknowns[u].std_error);
}

TEST(LikelihoodScene, AnUncertainEstimateIsTheBestOfAllStarts) {
  LikelihoodCase c1("C1");
  const std::vector<double> bound = c1.at(0.05).bound();
  const problems::Measurement noisy = problems::polluted(c1.problem, 1, 52);  // whose first start ends 7 bounds off and fits
  const Solution usual = solve(*problems::plan(c1.scene, noisy));
  c1.scene.identify.starts = 12;
  const Solution thorough = solve(*problems::plan(c1.scene, noisy));
  ASSERT_GE(thorough.search->minima.size(), 2u);
  for (std::size_t u = 0; u < bound.size(); ++u) {
    EXPECT_NEAR(usual.unknowns[u].value, thorough.unknowns[u].value, 0.01 * bound[u]);
    EXPECT_NEAR(usual.unknowns[u].value, c1.truth[u], 3.0 * bound[u]);
  }
}

TEST(LikelihoodScene, AnFrfThatSomeLinesLackIsLeftOutThere) {
  LikelihoodCase a1("A1");
  a1.at(0.01);
  problems::Measurement noisy = problems::polluted(a1.problem, 5, 0);
  const auto solve_it = [&] { return solve(*problems::plan(a1.scene, noisy)); };
  const Solution whole = solve_it();
  for (std::size_t line = 5; line < 12; ++line) {
    for (const auto& [r, c] : {std::pair(0u, 1u), std::pair(1u, 0u), std::pair(2u, 2u)}) {
      noisy.assembly.values[noisy.assembly.index(line, r, c)] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  const Solution less = solve_it();
  EXPECT_EQ(less.status, Status::ok) << less.message;
  EXPECT_EQ(less.fit.equations_used, whole.fit.equations_used - 7 * 2);
  EXPECT_LT(largest_error(less, a1.truth), 5.0);
}

TEST(LikelihoodScene, LinesOfNoBandAreNotUsed) {
  LikelihoodCase a1("A1");
  a1.at(0.01).scene.joints[0].bands_hz = {{400.0, 690.0}, {790.0, 1001.0}};
  const Solution solution = solve_noisy(a1);
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  std::size_t used = 0;
  for (const double ratio : solution.fit.chi_square->by_line) used += !std::isnan(ratio);
  EXPECT_EQ(used, 15u + 11u);
  for (std::size_t u = 0; u < solution.unknowns.size(); ++u) {
    EXPECT_NEAR(solution.unknowns[u].value, a1.truth[u / 2], 5.0 * *solution.unknowns[u].std_error);
  }
}

TEST(LikelihoodScene, EstimatesVariancesFromTheScatter) {
  LikelihoodCase rig("rig1");
  rig.scene.frequency.range_hz = Range{300.0, 700.0};
  rig.scene.identify.variance = VarianceChoice::local;
  rig.scene.identify.equations = {nj};
  const auto data = problems::trial_data(rig.scene, rig.problem);
  const Solution solution = solve_noisy(rig);
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  EXPECT_EQ(data->lines, solution.fit.lines);
}

void expect_error(const Scene& scene, const problems::Problem& problem, const std::vector<std::string>& parts) {
  try {
    problems::plan(scene, {problem.substructures, problem.assembly});
    FAIL() << "no error; expected: " << parts[0];
  } catch (const InputError& error) {
    for (const std::string& part : parts) EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

TEST(LikelihoodScene, WantsASymmetricJoint) {
  LikelihoodCase a1("A1");
  a1.scene.joints[0].matrices[restrictions::Kind::stiffness] = restrictions::Pattern::full;
  expect_error(a1.scene, a1.problem, {"[joint]", "reciprocal", "the joint is not symmetric", "pattern = \"symmetric\""});
}

TEST(LikelihoodScene, HasNoLinearSolver) {
  LikelihoodCase a1("A1");
  a1.scene.identify.solver = Solver::qr;
  expect_error(a1.scene, a1.problem, {"[identify] solver", "method \"likelihood\" has no solver \"qr\"", "use auto"});
}

TEST(LikelihoodScene, SaysWhatAnEquationLacks) {
  LikelihoodCase h4("H4", {nn, nj});
  expect_error(h4.scene, h4.problem, {"[identify] equations", "equation nj cannot be used", "the assembly has none of the joint DOFs"});
}

TEST(LikelihoodScene, AStartThatDoesNotFollowThePatternIsNamed) {
  LikelihoodCase a1("A1");
  a1.scene.identify.start[restrictions::Kind::stiffness] = {
      {1.0, 2.0, 0.0, 0.0}, {3.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
  const auto plan = problems::plan(a1.at(0.01).scene, {a1.problem.substructures, a1.problem.assembly});
  EXPECT_THROW(solve(*plan), InputError);
}

}  // namespace
}  // namespace jointid::ident
