#pragma once

#include "ident/algebra/solve_linear.hpp"
#include "ident/equations/line_assembler.hpp"
#include "ident/equations/rounding_scale.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// The accumulated system of all lines of a plan with linear equations.
struct Assembled {
  Accumulator accumulator;
  EquationCount equations;
  std::size_t lines = 0;
  RoundingScale rounding;  ///< only with Detail::full
};
Assembled assemble(Plan& plan, RunTime& runtime, const Control& control = {});

/// Its solution by the plan's solver.
LinearSolution solve(const Plan& plan, Accumulator& accumulator, Condition condition = Condition::compute);

}  // namespace jointid::ident
