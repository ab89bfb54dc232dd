#pragma once

#include <vector>

#include "ident/accumulator.hpp"

namespace jointid::ident {

/// Columns that move together along a direction that the data do not fix.
struct FreeDirection {
  std::vector<std::size_t> columns;  ///< strongest first
};

/// Solution of the reduced least-squares problem, in the scaled unknowns of its columns.
struct LinearSolution {
  std::vector<double> y;  ///< of minimum norm (after column scaling) when the rank is not full
  std::size_t rank = 0;
  double condition = 0.0;      ///< σ₁/σ_n of the system with columns scaled to about unit length; infinite if σ_n = 0
  double residual_norm = 0.0;  ///< of the compressed weighted rows
  std::vector<FreeDirection> free_directions;
  std::vector<std::size_t> undetermined;  ///< columns with a share in a free direction, ascending
  /// ‖row j of E⁺‖₂: by so much, at most, y_j changes when the right-hand side changes by 1. With Condition::compute and full rank.
  std::vector<double> inverse_norms;
  /// Of y: first-order bound of what the rounding of the solver does, for the rows as they were pushed. As inverse_norms.
  std::vector<double> rounding;
};

/// Whether LinearSolution::condition, inverse_norms and rounding are computed; that costs more than a small solution itself.
enum class Condition { skip, compute };

/// Column-pivoted QR of the stacked triangles, columns scaled by powers of two (which rounds nothing). A pivot counts as
/// zero when |R_kk| ≤ 16·n·ε·|R_11|.
LinearSolution solve_dense(Accumulator& accumulator, Condition condition = Condition::compute);

/// Sparse QR (SPQR) of the stacked triangles, for systems whose equations touch few of many columns. Same scaling; a column
/// counts as dependent when its pivot is ≤ 16·n·ε times the largest column norm. The norms of the rows of E⁺ are estimated from
/// random right-hand sides, within about a factor of 1.5.
LinearSolution solve_sparse(Accumulator& accumulator, Condition condition = Condition::compute);

/// Cholesky factorisation of the normal equations: the labelled fast mode. Loses twice the digits of solve_dense; rank is 0
/// when the matrix is not numerically positive definite.
LinearSolution solve_normal(Accumulator& accumulator, Condition condition = Condition::compute);

}  // namespace jointid::ident
