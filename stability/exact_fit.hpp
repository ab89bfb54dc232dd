#pragma once

#include <vector>

#include "ident/plan/plan.hpp"
#include "stability/exact_identification.hpp"

namespace jointid::stability {

/// What a nonlinear identification gives on the same FRFs in 50-digit arithmetic (no bands, lines that all fit): Gauss–Newton
/// steps from `start` (the unknowns in SI) until they are below 1e-20 of the unknowns, with Jacobians by differences of 1e-25.
/// Method likelihood: χ² over the joint and the substructure FRFs X, Y of every line, for the variances at the measured FRFs;
/// each line's own unknowns are eliminated by QR. Method newton: residuals (6.12) of all lines
/// (docs/formulas.md §7), weighted by 1/‖J diag θ‖.
/// Column norms are those of the Jacobian.
ExactEstimate fit_exactly(const ident::Plan& plan, const Sets& sets, const std::vector<double>& start);

}  // namespace jointid::stability
