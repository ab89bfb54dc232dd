#pragma once

#include "ident/control.hpp"
#include "ident/plan.hpp"

namespace jointid::ident {

/// Method "newton" (docs/formulas.md §7, thesis §6.12.2): the joint that predicts H_nn best, by the plan's solver.
void solve_newton(Plan& plan, const Control& control, Solution& out);

/// The solvers of method "newton", in the order in which messages name them.
const std::vector<std::string>& newton_solvers();

}  // namespace jointid::ident
