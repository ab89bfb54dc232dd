#pragma once

#include "ident/equations/rounding_scale.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// Fills Estimate::rounding and Fit::digits. FRFs with relative errors u move the estimate, to first order, by at most
///   |δy_j| ≤ u‖E⁺_j‖(‖right‖ + 2Σ|S∘Z_j| + 2‖r‖Σ_k‖E⁺_k‖Σ|S∘T_k|),
/// S = RoundingScale::coefficient, T_k the matrix that unknown k stands for; to this comes LinearSolution::rounding. All of it
/// over 1 − μ, μ = 2uΣ_k‖E⁺_k‖Σ|S∘T_k| ≥ ‖E⁺δE‖: with μ ≥ 1 the errors can hide that the rank is not full, and nothing is known.
/// A warning names unknowns that this may move by more than 1 % of the largest of their joint and unit, and the status is
/// `imprecise` when it is more than all of it. Nothing is done where the solution has no such bounds.
void judge_rounding(const Plan& plan, const minimise::LinearSolution& linear, const RoundingScale& scale, Solution& out);

}  // namespace jointid::ident
