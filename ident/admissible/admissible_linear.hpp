#pragma once

#include "ident/admissible/admissible_fit.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// Moves a least-squares solution to the nearest joint that meets the plan's constraints, in the metric of its own normal
/// equations: the constrained least-squares solution, exactly. The deviation that costs are counted in is at least 1e-11 of the
/// right side, which exact data do not reach. `rows` is the number of compressed real rows. With ties,
/// rank and free directions become those of the unknowns that the ties leave.
Admissibility constrain(const Plan& plan, const minimise::Accumulator& accumulator, std::size_t rows,
                        minimise::LinearSolution& linear, bool& converged);

/// Rank, condition and free directions of what the ties leave.
void tell_rank(const AdmissibleFit& fit, minimise::LinearSolution& linear);

}  // namespace jointid::ident
