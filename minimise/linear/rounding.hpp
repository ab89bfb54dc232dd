#pragma once

#include <Eigen/Core>

#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::minimise {

/// Unit roundoff of double precision times what the algorithms add up: a few operations per element and, over many blocks of
/// rows, the square root of their number.
double growth(std::size_t rows);

/// Fills LinearSolution::inverse_norms and rounding from the norms of the rows of E⁺ and of the columns of E, and ‖p‖.
///
/// Orthogonal reduction solves a system whose columns are off by η‖E_k‖ (η = growth): |δy_j| ≤ η‖E⁺_j‖(Σ‖E_k‖|y_k| + ‖p‖ +
/// ‖r‖Σ‖E⁺_k‖‖E_k‖). The normal equations are off by η‖E_i‖‖E_k‖: |δy_j| ≤ η‖E⁺_j‖(Σ‖E⁺_k‖‖E_k‖)(Σ‖E_k‖|y_k| + ‖p‖).
struct SystemNorms {
  Eigen::VectorXd inverse_rows, columns;
  double right = 0.0;
};
void bound_rounding(const SystemNorms& norms, Reduction reduction, std::size_t rows, LinearSolution& out);

}  // namespace jointid::minimise
