#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ident/identify.hpp"
#include "tests/ident/memory_systems.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

problems::Measurement clean(const problems::Problem& problem) { return {problem.substructures, problem.assembly}; }

/// Every non-empty subset of the equations.
std::vector<std::vector<Equation>> subsets(const std::vector<Equation>& equations) {
  std::vector<std::vector<Equation>> result;
  for (std::size_t mask = 1; mask < (1u << equations.size()); ++mask) {
    std::vector<Equation>& subset = result.emplace_back();
    for (std::size_t i = 0; i < equations.size(); ++i) {
      if (mask >> i & 1u) subset.push_back(equations[i]);
    }
  }
  return result;
}

std::string text(const IdentifySection& identify) {
  std::string result = name(identify.method);
  for (const Equation equation : identify.equations) result += " " + name(equation);
  return result + " " + weighting::name(identify.weighting) + " " + std::to_string(identify.delta);
}

/// Largest error of the unknowns, relative to the largest element of the same matrix.
double largest_error(const problems::Problem& problem, const Solution& solution) {
  std::map<char, double> largest;
  for (const problems::ExactUnknown& exact : problem.unknowns) {
    largest[exact.name[0]] = std::max(largest[exact.name[0]], std::abs(exact.value));
  }
  double error = 0.0;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    const problems::ExactUnknown& exact = problem.unknowns[u];
    EXPECT_EQ(solution.unknowns[u].name, exact.name);
    error = std::max(error, std::abs(solution.unknowns[u].value - exact.value) / largest[exact.name[0]]);
  }
  return error;
}

/// H_ba⁺ of the direct solution magnifies the rounding of the FRFs, by up to 1e6 here.
double tolerance(Method method) { return method == Method::direct ? 1e-6 : 1e-9; }

void expect_exact(const problems::Problem& problem, const IdentifySection& identify) {
  Scene scene = problems::scene(problem);
  scene.identify = identify;
  const auto plan = problems::plan(scene, clean(problem));
  const Solution solution = solve(*plan);
  EXPECT_EQ(solution.status, Status::ok) << text(identify) << solution.message;
  EXPECT_EQ(solution.used.equations, identify.equations);
  EXPECT_LE(largest_error(problem, solution), tolerance(identify.method)) << text(identify);
}

void expect_exact_for_all(const std::string& name, Method method, const std::vector<Equation>& equations) {
  const problems::Problem problem = problems::make(name);
  for (const std::vector<Equation>& subset : subsets(equations)) {
    for (const weighting::Weighting weighting : all_weightings) {
      for (const double delta : {0.0, 0.1}) {
        IdentifySection identify;
        identify.method = method;
        identify.equations = subset;
        identify.weighting = weighting;
        identify.delta = delta;
        expect_exact(problem, identify);
      }
    }
  }
}

const std::vector<Equation> all_equations = {Equation::nn, Equation::nj, Equation::jj, Equation::jn};

class Exactness : public ::testing::TestWithParam<const char*> {};

TEST_P(Exactness, MethodOneFindsTheJointOfNoiseFreeData) {
  expect_exact_for_all(GetParam(), Method::one, all_equations);
}

TEST_P(Exactness, MethodTwoFindsTheJointOfNoiseFreeData) {
  expect_exact_for_all(GetParam(), Method::two, {Equation::jj, Equation::jn});
}

TEST_P(Exactness, TheDirectSolutionFindsTheJointOfNoiseFreeData) {
  expect_exact_for_all(GetParam(), Method::direct, {Equation::nn});
}

INSTANTIATE_TEST_SUITE_P(Cases, Exactness, ::testing::Values("A1", "A9", "A10", "B", "C1", "C2"));

}  // namespace
}  // namespace jointid::ident
