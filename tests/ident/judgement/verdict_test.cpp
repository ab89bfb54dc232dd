#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "base/text.hpp"
#include "ident/identify.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/passivity.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/require.hpp"

/// That `ok` means it: what an estimate's own errors, one line or the χ² beside it say against it.
namespace jointid::ident {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Control judged() {
  Control control;
  control.threads = 1;
  control.judgement = Judgement::data;
  return control;
}

/// The largest error of an unknown in parts of the largest.
double error_of(const problems::Problem& problem, const Solution& found) {
  double size = 0.0, error = 0.0;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    size = std::max(size, std::abs(problem.unknowns[u].value));
    error = std::max(error, std::abs(found.unknowns[u].value - problem.unknowns[u].value));
  }
  return error / size;
}

std::size_t errors_of(const Solution& found) {
  return static_cast<std::size_t>(
      std::ranges::count_if(found.unknowns, [](const Estimate& unknown) { return unknown.error_estimate.has_value(); }));
}

/// Case H4 (only H_nn) by method newton, from the start of the thesis or that of the direct solution.
Solution h4(const std::string& solver, bool start, bool noise) {
  const problems::Problem problem = problems::make("H4");
  Scene scene = problems::scene(problem);
  scene.identify.solver = parse_solver(solver);
  if (!start) scene.identify.start.clear();
  return solve(*problems::plan(scene, noise ? problems::polluted(problem, 1, 0)
                                            : problems::Measurement{problem.substructures, problem.assembly}),
               judged());
}

/// Case H3 (only H_nn) by method direct: FRFs are explained, by joints that no springs are.
TEST(Verdict, OfDirectIsNotOkWithAnIndefiniteStiffness) {
  const problems::Problem problem = problems::make("H3");
  Scene scene = problems::scene(problem);
  scene.identify.method = Method::direct;
  for (const std::uint64_t seed : {101U, 12U, 7U, 15U}) {
    const Solution found = solve(*problems::plan(scene, problems::polluted(problem, seed, 0)), judged());
    EXPECT_GT(error_of(problem, found), 1.0) << seed;
    EXPECT_NE(found.status, Status::ok) << seed;
  }
  const Solution clean = solve(*problems::plan(scene, {problem.substructures, problem.assembly}), judged());
  EXPECT_EQ(clean.status, Status::ok) << clean.message;
}

TEST(Verdict, OfNewtonIsNotOkWhereNoiseLeavesAnotherJoint) {
  for (const char* solver : {"levenberg-marquardt", "newton"}) {
    for (const bool start : {true, false}) {
      const Solution found = h4(solver, start, true);
      EXPECT_NE(found.status, Status::ok) << solver << ' ' << start;
      EXPECT_THAT(found.message, Not(IsEmpty()));
      EXPECT_TRUE(!is_usable(found.status) || errors_of(found) == found.unknowns.size());
    }
  }
}

TEST(Verdict, OfNewtonIsOkWithoutNoiseAndItsErrorsAreRounding) {
  const Solution found = h4("levenberg-marquardt", true, false);
  EXPECT_EQ(found.status, Status::ok) << found.message;
  ASSERT_EQ(errors_of(found), found.unknowns.size());
  for (const Estimate& unknown : found.unknowns)
    EXPECT_LT(*unknown.error_estimate, 1e-6 * std::abs(unknown.value)) << unknown.name;
}

TEST(Verdict, OfTheDirectSolutionIsNotOkWhereItIsWrong) {
  for (const char* name : {"A1", "H3"}) {
    const problems::Problem problem = problems::make(name);
    Scene scene = problems::scene(problem);
    scene.identify = {};
    scene.identify.method = Method::direct;
    problems::Measurement data = problems::polluted(problem, 1, 0);
    data.assembly = problems::without(data.assembly, problem.joint_dofs);
    const Solution found = solve(*problems::plan(scene, std::move(data)), judged());
    ASSERT_GT(error_of(problem, found), 0.5) << name;
    EXPECT_NE(found.status, Status::ok) << name;
  }
}

/// Exact FRFs that state no noise, and a joint of a form that it does not have: the FRFs by it are far off.
TEST(Verdict, IsNotOkWhereTheFrfsAreFarOffAndNothingStatesTheNoise) {
  const problems::Problem problem = problems::make("A1");
  for (const Method method : {Method::one, Method::direct}) {
    Scene scene = problems::scene(problem);
    scene.noise.reset();
    scene.identify = {};
    scene.identify.method = method;
    const Solution right = solve(*problems::plan(scene, {problem.substructures, problem.assembly}), judged());
    EXPECT_EQ(right.status, Status::ok) << name(method) << ": " << right.message;
    for (auto& [kind, matrix] : scene.joints.front().matrices) matrix = restrictions::Pattern::diagonal;
    const Solution wrong = solve(*problems::plan(scene, {problem.substructures, problem.assembly}), judged());
    ASSERT_TRUE(wrong.fit.asm_frf_error);
    EXPECT_GT(*wrong.fit.asm_frf_error, 10.0) << name(method);
    EXPECT_NE(wrong.status, Status::ok) << name(method);
  }
}

/// A6 by method one with one cell of the assembly a millionfold too large.
TEST(Verdict, NamesTheLineAndTheFrfThatDecideAlone) {
  problems::Problem problem = problems::make("A6");
  std::get<frf::NoiseModel>(problem.noise) = {.kind = frf::NoiseKind::circular, .level = 0.01};
  Scene scene = problems::scene(problem);
  scene.identify.weighting = weighting::Weighting::wb;
  scene.noise = NoiseSection{.model = "circular", .level = 0.01, .frf_model = std::get<frf::NoiseModel>(problem.noise)};
  problems::Measurement data = problems::polluted(problem, 1, 0);
  EXPECT_EQ(solve(*problems::plan(scene, data), judged()).status, Status::ok);
  const std::size_t line = 100, row = frf::find_coordinate(data.assembly.header.response, frf::Dof::parse("3:+Y")),
                    column = frf::find_coordinate(data.assembly.header.reference,
                                                  frf::Dof::parse("5:+Y"));  // at the joint: it weighs a row
  data.assembly.values[data.assembly.index(line, row, column)] *= 1e6;
  const Solution found = solve(*problems::plan(scene, data), judged());
  EXPECT_EQ(found.status, Status::doubtful);
  EXPECT_THAT(found.message, HasSubstr("One line decides"));
  EXPECT_THAT(found.message, HasSubstr(digits(data.assembly.header.frequency_hz[line], "%.6g") + " Hz"));
  EXPECT_THAT(found.message, HasSubstr("FRF 3:+Y/5:+Y of the assembly"));
}

TEST(Verdict, TheChiSquareShownIsThatOfTheLinesThatItGoesBy) {
  problems::Problem problem = problems::make("A1");
  Scene scene = problems::scene(problem);
  scene.identify = {};
  scene.identify.method = Method::likelihood;
  problems::Measurement data = problems::polluted(problem, 1, 0);
  const std::size_t line = 12;
  for (std::size_t i = 0; i < data.assembly.header.entries(); ++i)
    data.assembly.values[line * data.assembly.header.entries() + i] *= -40.0;
  const Solution found = solve(*problems::plan(scene, data), judged());
  const ChiSquare& chi = found.fit.chi_square.value();
  EXPECT_EQ(chi.outlying_lines, 1u);
  EXPECT_GT(chi.by_line[line], 100.0);
  EXPECT_LT(chi.value / chi.degrees_of_freedom, 1.4);
}

TEST(Verdict, EveryStateThatIsKeptHoldsTiesAndTellsWhatWasDone) {
  const problems::Problem problem = problems::make("A1");
  Scene scene = problems::scene(problem);
  scene.identify = {};
  scene.identify.method = Method::likelihood;
  scene.identify.ties = {"K(1,1) = K(3,3)"};
  const auto plan = problems::plan(scene, problems::polluted(problem, 1, 0));
  const auto place = [&](const std::string& name) {
    const auto found = std::ranges::find(problem.unknowns, name, &problems::ExactUnknown::name);
    return static_cast<std::size_t>(found - problem.unknowns.begin());
  };
  const std::size_t one = place("K(1,1)"), other = place("K(3,3)");
  std::size_t states = 0;
  Control control = judged();
  control.so_far = [&](const Solution& found) {
    ++states;
    ASSERT_EQ(found.unknowns.size(), problem.unknowns.size());
    EXPECT_NEAR(found.unknowns[one].value, found.unknowns[other].value, 1e-9 * std::abs(found.unknowns[one].value)) << states;
    EXPECT_GT(found.fit.equations_used, 0u) << states;
    EXPECT_EQ(found.fit.lines, plan->lines.size()) << states;
    EXPECT_GT(found.runtime_s.total, 0.0) << states;
  };
  solve(*plan, control);
  EXPECT_GT(states, 3u);
}

/// Unknowns of a scene with a joint of A1, with values and errors of a test.
struct ToldErrors {
  ToldErrors() : problem(problems::make("A1")) {
    plan = problems::plan(problems::scene(problem), {problem.substructures, problem.assembly});
    for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
      Estimate unknown;
      unknown.name = problem.unknowns[u].name;
      unknown.unit = plan->restriction.unknowns[u].unit;
      unknown.value = problem.unknowns[u].value;
      unknown.error_estimate = 0.01 * std::abs(unknown.value);
      found.unknowns.push_back(unknown);
    }
  }

  void tell() {
    std::vector<double> theta;
    Eigen::MatrixXd covariance =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(found.unknowns.size()), static_cast<Eigen::Index>(found.unknowns.size()));
    for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
      theta.push_back(found.unknowns[u].value / plan->unscale(u));
      covariance(static_cast<Eigen::Index>(u), static_cast<Eigen::Index>(u)) =
          std::pow(*found.unknowns[u].error_estimate / plan->unscale(u), 2);
    }
    tell_errors(*plan, theta, covariance, found);
  }

  problems::Problem problem;
  std::unique_ptr<Plan> plan;
  Solution found;
};

TEST(TellErrors, SaysNothingOfAGoodEstimate) {
  ToldErrors of;
  of.tell();
  EXPECT_EQ(of.found.status, Status::ok) << of.found.message;
  EXPECT_THAT(of.found.warnings, IsEmpty());
}

TEST(TellErrors, ANegativeDiagonalBeyondItsIntervalIsNotPassive) {
  ToldErrors of;
  Estimate& first = of.found.unknowns.front();  // K(1,1)
  first.value = -1e5;
  first.error_estimate = 6e4;
  of.tell();
  EXPECT_THAT(of.found.message, Not(HasSubstr("is negative at")));  // 1.7 errors
  first.error_estimate = 4e4;
  of.found.status = Status::ok;
  of.found.message.clear();
  of.tell();
  EXPECT_EQ(of.found.status, Status::doubtful);
  EXPECT_THAT(of.found.message, HasSubstr("is negative at " + of.plan->restriction.dofs.front().name() + ", -1e+05 ± 4e+04"));
}

TEST(TellErrors, ErrorsLargerThanMostValuesAreDoubtful) {
  ToldErrors of;
  for (std::size_t u = 0; u < of.found.unknowns.size(); ++u) {
    if (u % 3 != 0) of.found.unknowns[u].error_estimate = 5e6;
  }
  of.tell();
  EXPECT_EQ(of.found.status, Status::doubtful);
  EXPECT_THAT(of.found.message, HasSubstr("larger than values in"));
}

TEST(TellErrors, NoValidDigitOfKIsDoubtfulAndOfDIsSaidOfD) {
  ToldErrors of;
  double largest = 0.0;
  const auto is_damping = [](const Estimate& unknown) { return unknown.name.starts_with("D") && unknown.unit == "N/m"; };
  for (Estimate& unknown : of.found.unknowns) largest = std::max(largest, is_damping(unknown) ? std::abs(unknown.value) : 0.0);
  const auto without = std::ranges::find_if(of.found.unknowns, is_damping);
  without->error_estimate = 1.1 * largest;
  of.tell();
  EXPECT_EQ(of.found.status, Status::ok) << of.found.message;
  ASSERT_EQ(of.found.warnings.size(), 1u);
  EXPECT_THAT(of.found.warnings.front(), HasSubstr("hysteretic damping D has no valid digit in N/m (" + without->name + "): errors reach"));
  EXPECT_THAT(of.found.message, HasSubstr("The status is that of the stiffness K alone: the hysteretic damping D has no valid digit in N/m"));
  of.found.unknowns.front().error_estimate = 2.0 * std::abs(of.found.unknowns.front().value);  // K(1,1), the largest in N/m
  of.tell();
  EXPECT_EQ(of.found.status, Status::doubtful);
  EXPECT_THAT(of.found.message, HasSubstr("stiffness K has no valid digit in N/m"));
}

/// A method on a problem with noise of some size.
struct MethodCase {
  const char* name;
  const char* problem;
  Method method;
  Solver solver;
};

double error_of(const Estimate& unknown) {
  return unknown.std_error ? *unknown.std_error : unknown.error_estimate.value_or(0.0);
}

/// What an engineer would hold against `ok`, worked out from the numbers of the result alone.
struct Contradictions {
  std::size_t larger = 0, negative = 0;
  std::map<std::string, std::array<double, 2>> largest;  ///< value and error by matrix and unit

  explicit Contradictions(const Solution& found) {
    std::map<std::string, double> size;
    for (const Estimate& each : found.unknowns) {
      auto& [value, error] = largest[each.name.substr(0, 1) + " in " + each.unit];
      value = std::max(value, std::abs(each.value));
      error = std::max(error, error_of(each));
      size[each.name.substr(0, 1) + each.unit] = value;
    }
    for (const Estimate& each : found.unknowns) {
      const double of_group = largest[each.name.substr(0, 1) + " in " + each.unit][0];
      larger += error_of(each) > std::max(std::abs(each.value), 0.1 * of_group);
      const bool diagonal = each.name.size() == 6 && each.name[2] == each.name[4];  // "K(1,1)"
      negative += diagonal && each.value + 2.0 * error_of(each) < 0.0;
    }
  }
  bool without_digit(char matrix) const {
    return std::ranges::any_of(largest, [&](const auto& each) { return each.first[0] == matrix && each.second[1] >= each.second[0]; });
  }
};

class EveryMethod : public testing::TestWithParam<MethodCase> {};

/// From noise that says all to noise that says nothing.
TEST_P(EveryMethod, DoesNotSayOkOfNumbersThatItsOwnErrorsContradict) {
  const problems::Problem problem = problems::make(GetParam().problem);
  Scene scene = problems::scene(problem);
  scene.identify.method = GetParam().method;
  scene.identify.automatic = false;
  scene.identify.solver = GetParam().solver;
  if (GetParam().method == Method::two) scene.identify.equations = {Equation::jn};
  std::size_t told = 0;
  for (const double level : {0.001, 0.03, 0.4}) {
    problems::Problem noisy = problem;
    auto& noise = std::get<frf::NoiseModel>(noisy.noise);
    noise.level = level;
    scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = level, .frf_model = noise};
    const Solution found = solve(*problems::plan(scene, problems::polluted(noisy, 1, 0)), judged());
    if (found.status != Status::ok) continue;
    const Contradictions of(found);
    EXPECT_EQ(of.negative, 0u) << level;
    EXPECT_LE(2 * of.larger, found.unknowns.size()) << level;
    EXPECT_FALSE(of.without_digit('K')) << level;
    if (of.without_digit('D')) {
      EXPECT_THAT(found.message, HasSubstr("The status is that of the stiffness K alone")) << level;
      ++told;
    }
    if (found.fit.chi_square) {
      EXPECT_LT(found.fit.chi_square->value, 2.0 * found.fit.chi_square->degrees_of_freedom) << level;
    }
  }
  if (GetParam().method == Method::one) {
    EXPECT_GT(told, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Verdict, EveryMethod,
                         testing::Values(MethodCase{"one", "A1", Method::one, Solver::automatic},
                                         MethodCase{"two", "A1", Method::two, Solver::automatic},
                                         MethodCase{"likelihood", "A1", Method::likelihood, Solver::automatic},
                                         MethodCase{"direct", "H3", Method::direct, Solver::automatic},
                                         MethodCase{"newton", "H4", Method::newton, Solver::automatic}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace jointid::ident
