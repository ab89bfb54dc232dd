#pragma once

#include "ident/equations/line_assembler.hpp"
#include "ident/equations/rounding_scale.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/solve_linear.hpp"

namespace jointid::ident {

/// The accumulated system of all lines of a plan with linear equations.
struct Assembled {
  minimise::Accumulator accumulator;
  EquationCount equations;
  std::size_t lines = 0;
  RoundingScale rounding;  ///< only with Detail::full
};

/// Of all lines of the plan, or of those of them that are given.
Assembled assemble(const Plan& plan, RunTime& runtime, const Control& control = {});
Assembled assemble(const Plan& plan, const std::vector<Line>& of, RunTime& runtime, const Control& control = {});

/// How rows are reduced for the plan's solver.
minimise::Reduction reduction_of(const Plan& plan);

/// Its solution by the plan's solver.
minimise::LinearSolution solve(const Plan& plan, minimise::Accumulator& accumulator,
                               minimise::Condition condition = minimise::Condition::compute);

}  // namespace jointid::ident
