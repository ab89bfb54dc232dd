#pragma once

#include "ident/control.hpp"
#include "ident/plan.hpp"


namespace jointid::ident {

/// Carries out a plan with method "likelihood": reads, starts from the linear estimate or the scene's, fits, and fills `out`
/// with unknowns, standard errors and 95 % intervals from the Cramér–Rao covariance, matrices, χ² and figures of merit.
void solve_likelihood(Plan& plan, const Control& control, Solution& out);

}  // namespace jointid::ident
