#pragma once

#include "ident/algebra/linear_solution.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// What an estimate says: rank, condition, status, unknowns, joint matrices and figures of merit of `out`, which has none of them
/// yet.
void interpret(const Plan& plan, const LinearSolution& linear, Solution& out);

}  // namespace jointid::ident
