#pragma once

#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::minimise {

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

}  // namespace jointid::minimise
