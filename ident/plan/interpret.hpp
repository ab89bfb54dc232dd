#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// What an estimate says: rank, condition, status, unknowns, joint matrices and figures of merit of `out`, which has none of them
/// yet.
void interpret(const Plan& plan, const minimise::LinearSolution& linear, Solution& out);

}  // namespace jointid::ident
