#pragma once

#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::minimise {

/// Whether LinearSolution::condition, inverse_norms and rounding are computed; that costs more than a small solution itself.
enum class Condition { skip, compute };

/// Column-pivoted QR of the stacked triangles, columns scaled by powers of two (which rounds nothing). A pivot counts as
/// zero when |R_kk| ≤ 16·n·ε·|R_11|.
LinearSolution solve_dense(Accumulator& accumulator, Condition condition = Condition::compute);

/// How a sparse system is solved.
enum class SparseWay {
  qr,       ///< SPQR
  cholmod,  ///< normal equations by CHOLMOD, corrected twice with residuals of the rows
  ldlt      ///< normal equations by Eigen's LDLᵀ, corrected: without GPL
};

/// The stacked triangles where equations touch few of many columns. Same scaling. SPQR orders by AMD; a column counts as dependent when its
/// pivot is ≤ 16·n·ε times the largest column norm, and a direction when inverse iteration with R finds a singular value ≤ n·ε·σ₁ there.
/// The normal equations, corrected, keep as many digits while the condition number is below 1e6; from there on, and where they are not
/// positive definite, QR takes over (SPQR, or solve_dense() without it). The norms of the rows of E⁺ are exact up to that condition number
/// (SparseCovariance); beyond it they are estimated from random right-hand sides, within about a factor of 1.5.
LinearSolution solve_sparse(Accumulator& accumulator, Condition condition = Condition::compute, SparseWay way = SparseWay::qr);

/// Cholesky factorisation of the normal equations: the labelled fast mode. Loses twice the digits of solve_dense; rank is 0
/// when the matrix is not numerically positive definite.
LinearSolution solve_normal(Accumulator& accumulator, Condition condition = Condition::compute);

}  // namespace jointid::minimise
