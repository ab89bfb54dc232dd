// Constraints that the data contradict are no `ok`; true ones are.
#include <gmock/gmock.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "base/control.hpp"
#include "ident/judgement/judge_constraints.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using ::testing::HasSubstr;
using ::testing::Not;

struct Constrained : LikelihoodCase {
  Constrained(const std::string& name, Method method, double level) : LikelihoodCase(name, level) {
    scene.identify = problems::scene(problem).identify;
    scene.identify.method = method;
    if (method == Method::likelihood) scene.identify.equations = {Equation::nn, Equation::nj};
    if (traits(method).iterates) scene.identify.solver = Solver::automatic;
    if (method == Method::newton) scene.identify.start = scene.truth;
    if (method == Method::direct) scene.identify.equations.clear();
  }

  Solution solved(std::uint64_t seed) const {
    Control control;
    control.judgement = Judgement::data;
    control.threads = 1;
    return solve(*polluted(seed), control);
  }

  double truth(const std::string& name) const {
    for (const auto& each : problem.unknowns) {
      if (each.name == name) return each.value;
    }
    return std::nan("");
  }
};

constexpr const char* contradiction = "The data contradict the constraints";

bool is_contradicted(const Solution& found) { return found.message.find(contradiction) != std::string::npos; }

/// 500 Hz is an eigenfrequency of the assembly of A1 at no joint like the true one.
TEST(JudgedConstraints, AnEigenfrequencyThatTheAssemblyDoesNotHaveIsDoubtful) {
  Constrained a1("A1", Method::one, 0.05);
  a1.scene.identify.frequencies_hz = {500.0};
  std::size_t told = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Solution found = a1.solved(seed);
    EXPECT_NE(found.status, Status::ok) << seed;
    if (found.status == Status::not_converged) continue;
    EXPECT_THAT(found.message, HasSubstr("[identify] frequencies")) << seed;
    ++told;
  }
  EXPECT_GE(told, 3u);
}

/// Exact equalities between noisy FRFs: what is `ok` is near the truth, seen by intervals of the estimate without them.
TEST(JudgedConstraints, ATrueFrequencyThatNoiseSpoilsIsDoubtful) {
  Constrained a1("A1", Method::one, 0.05);
  a1.scene.identify.frequencies_hz = {537.1200253612756};
  const double truth = a1.truth("K(1,1)");
  std::size_t spoiled = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Solution found = a1.solved(seed);
    const bool far = std::abs(found.unknowns[0].value - truth) > 0.3 * truth;
    spoiled += far ? 1 : 0;
    EXPECT_FALSE(far && found.status == Status::ok) << seed << ": " << found.unknowns[0].value;
    EXPECT_FALSE(is_contradicted(found)) << seed << ": " << found.message;
  }
  EXPECT_GE(spoiled, 1u);
}

struct MethodOn {
  const char* problem;
  Method method;
  double level;
};

struct EveryMethod : testing::TestWithParam<MethodOn> {};

/// A bound that the truth is far outside of, a tie that it does not meet: no ok. The same where it meets them: no word.
TEST_P(EveryMethod, ConstraintsAreHeldAgainstTheData) {
  const auto [name, method, level] = GetParam();
  const Constrained plain(name, method, level);
  const std::string first = plain.problem.unknowns[0].name, second = plain.problem.unknowns[1].name;
  const double one = plain.problem.unknowns[0].value, other = plain.problem.unknowns[1].value;
  Constrained bounded = plain, tied = plain, right = plain;
  bounded.scene.identify.bounds = {{first, -2.0 * std::abs(one), 0.6 * one}};
  tied.scene.identify.ties = {first + " = " + std::to_string(2.0 * one / other) + "*" + second};
  const auto around = [](double value) {
    return Bound{"", std::min(0.5 * value, 3.0 * value), std::max(0.5 * value, 3.0 * value)};
  };
  right.scene.identify.bounds = {{first, around(one).lower, around(one).upper}};
  right.scene.identify.ties = {first + " = " + std::to_string(one / other) + "*" + second};
  const Solution by_bound = bounded.solved(1), by_tie = tied.solved(1), by_right = right.solved(1);
  for (const Solution* wrong : {&by_bound, &by_tie}) {
    EXPECT_NE(wrong->status, Status::ok) << wrong->message;
    EXPECT_TRUE(is_contradicted(*wrong) || wrong->status != Status::doubtful) << wrong->message;
  }
  if (is_contradicted(by_bound)) {
    EXPECT_THAT(by_bound.message, HasSubstr(first + " <= "));
  }
  if (is_contradicted(by_tie)) {
    EXPECT_THAT(by_tie.message, HasSubstr("\"" + tied.scene.identify.ties[0] + "\""));
  }
  EXPECT_TRUE(is_contradicted(by_bound) || is_contradicted(by_tie));
  EXPECT_FALSE(is_contradicted(by_right)) << by_right.message;
  if (!is_usable(by_right.status)) return;
  for (const Estimate& unknown : by_right.unknowns) {
    ASSERT_TRUE(unknown.error()) << unknown.name << ", " << by_right.message;
    EXPECT_GT(*unknown.error(), 0.0) << unknown.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Judged, EveryMethod,
                         testing::Values(MethodOn{"A1", Method::one, 0.02}, MethodOn{"A11", Method::two, 0.005},
                                         MethodOn{"A1", Method::direct, 1e-5}, MethodOn{"H4", Method::newton, 0.01},
                                         MethodOn{"A1", Method::likelihood, 0.05}),
                         [](const auto& each) { return name(each.param.method); });

/// 200 seeds: docs/status.md.
TEST(JudgedConstraints, TrueOnesAreNoContradiction) {
  for (const Method method : {Method::one, Method::likelihood}) {
    Constrained a1("A1", method, 0.05);
    a1.scene.joints[0].definite = {Kind::stiffness, Kind::hysteretic_damping};
    a1.scene.identify.ties = {"K(1,1) = -1*K(1,3)"};
    a1.scene.identify.bounds = {{"K(1,1)", a1.truth("K(1,1)"), 1e9}};
    if (method == Method::one) a1.scene.identify.frequencies_hz = {537.1200253612756, 672.1457154368505};
    int told = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) told += is_contradicted(a1.solved(seed)) ? 1 : 0;
    EXPECT_LE(told, 1) << name(method);
  }
}

/// Errors under constraints are of the size of what the estimate misses the truth by, ties and bounds included.
TEST(JudgedConstraints, LinearMethodsStateErrorsUnderConstraints) {
  Constrained a1("A1", Method::one, 0.05);
  a1.scene.joints[0].definite = {Kind::stiffness};
  a1.scene.identify.ties = {"K(1,1) = -1*K(1,3)"};
  a1.scene.identify.bounds = {{"K(2,2)", 0.0, 1e9}};
  double squares = 0.0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Solution found = a1.solved(seed);
    ASSERT_EQ(found.bands.front().errors.count(Kind::stiffness), 1u) << seed;
    for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
      ASSERT_TRUE(found.unknowns[u].error_estimate) << found.unknowns[u].name;
      if (found.unknowns[u].name[0] != 'K') continue;
      squares += std::pow((found.unknowns[u].value - a1.truth(found.unknowns[u].name)) / *found.unknowns[u].error_estimate, 2);
      ++count;
    }
  }
  const double ratio = std::sqrt(squares / static_cast<double>(count));
  EXPECT_GT(ratio, 0.4);
  EXPECT_LT(ratio, 2.0);
}

TEST(JudgedConstraints, NewtonStatesErrorsUnderConstraints) {
  Constrained h4("H4", Method::newton, 1e-4);
  const std::string first = h4.problem.unknowns[0].name;
  const double truth = h4.problem.unknowns[0].value;
  h4.scene.identify.bounds = {{first, truth - 0.5 * std::abs(truth), truth + 0.5 * std::abs(truth)}};
  const Solution free = Constrained("H4", Method::newton, 1e-4).solved(1), found = h4.solved(1);
  ASSERT_TRUE(is_usable(found.status)) << found.message;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {  // the bound is not active; the variance of the second estimate differs
    ASSERT_TRUE(found.unknowns[u].error_estimate) << found.unknowns[u].name;
    EXPECT_NEAR(*found.unknowns[u].error_estimate, *free.unknowns[u].error_estimate, 0.4 * *free.unknowns[u].error_estimate);
  }
}

/// At a bound that all groups of lines are held at, the error is that of the estimate without it: not zero.
TEST(JudgedConstraints, AnUnknownAtItsBoundHasAnError) {
  Constrained a1("A1", Method::one, 0.02);
  const double truth = a1.truth("K(1,1)");
  a1.scene.identify.bounds = {{"K(1,1)", 1.2 * truth, 1e9}};
  const Solution found = a1.solved(3);
  EXPECT_NEAR(found.unknowns[0].value, 1.2 * truth, 1e-6 * truth);
  ASSERT_TRUE(found.unknowns[0].error_estimate);
  EXPECT_GT(*found.unknowns[0].error_estimate, 1e-3 * truth);
  EXPECT_LT(*found.unknowns[0].error_estimate, truth);
}

/// Exact data, whose errors are those of rounding: true constraints cost nothing, and a hundredth beside the truth is told.
TEST(JudgedConstraints, ExactDataContradictWhatIsAHundredthOff) {
  Constrained a1("A1", Method::one, 1e-12);
  Control control;
  control.judgement = Judgement::data;
  a1.scene.identify.ties = {"K(1,1) = -1*K(1,3)"};
  EXPECT_THAT(solve(*a1.clean(), control).message, Not(HasSubstr(contradiction)));
  a1.scene.identify.ties = {"K(1,1) = -1.03*K(1,3)"};
  EXPECT_THAT(solve(*a1.clean(), control).message, HasSubstr(contradiction));
}

/// T² of one equation is t².
TEST(JudgedConstraints, LikelyCostOfOneEquationIsStudents) {
  for (const std::size_t lines : {6UL, 12UL, 32UL}) {
    const boost::math::students_t_distribution<double> law(static_cast<double>(lines) - 1.0);
    EXPECT_NEAR(likely_cost(1, lines), std::pow(boost::math::quantile(complement(law, 5e-4)), 2), 1e-6 * likely_cost(1, lines));
  }
  EXPECT_NEAR(likely_cost(1, 1'000'000), 10.83, 0.01);
}

}  // namespace
}  // namespace jointid::ident
