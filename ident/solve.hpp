#pragma once

#include "ident/control.hpp"
#include "ident/linear_solution.hpp"
#include "ident/plan.hpp"
#include "ident/rounding_scale.hpp"
#include "ident/solution.hpp"

namespace jointid::ident {

/// Carries out a plan: reads what it names line by line, assembles, solves, predicts and judges. Throws InputError when the
/// data break their promises; a numerical outcome is Solution::status.
Solution solve(Plan& plan, const Control& control = {});

/// The inner part of solve() for callers that repeat it: the accumulated system of all lines of a plan…
struct Assembled {
  Accumulator accumulator;
  EquationCount equations;
  std::size_t lines = 0;
  RoundingScale rounding;  ///< only with Detail::full
};
Assembled assemble(Plan& plan, RunTime& runtime, const Control& control = {});

/// … and its solution by the plan's solver.
LinearSolution solve(const Plan& plan, Accumulator& accumulator, Condition condition = Condition::compute);

/// What that solution says: rank, condition, status, unknowns, joint matrices and figures of merit of `out`, which has none
/// of them yet.
void interpret(const Plan& plan, const LinearSolution& linear, Solution& out);

}  // namespace jointid::ident
