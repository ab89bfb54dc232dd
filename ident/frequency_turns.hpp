#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Solves a plan by its method. Where the scene states eigenfrequencies of the assembly and the method iterates, in turns: each has the
/// conditions of Eigenfrequencies at the joint of the turn before, which are linear, as ties, the first none. They end where no unknown
/// moves by more than a thousandth of its standard error (without one: 1e-6 of the largest of its unit). Leaves the plan as it was.
void solve_by_method(Plan& plan, const Control& control, Solution& out);

}  // namespace jointid::ident
