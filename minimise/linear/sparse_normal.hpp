#pragma once

#include <optional>

#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/stacked_triangles.hpp"

namespace jointid::minimise {

/// The normal equations of the stacked triangles, corrected by the residuals of the rows: y += (AᵀA)⁻¹Aᵀ(b − Ay). Empty where they are not
/// positive definite or their condition number is above 1e12, that of A above 1e6.
std::optional<LinearSolution> solve_sparse_normal(Accumulator& accumulator, Condition condition, SparseWay way);

}  // namespace jointid::minimise
