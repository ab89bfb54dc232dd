#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::stability {

/// A least-squares problem whose elements are unevaluated sums of two doubles, high + low (about 32 digits).
struct Rows {
  std::size_t unknowns = 0;
  std::vector<double> high;  ///< [rows × (unknowns + 1)], the right-hand side last
  std::vector<double> low;   ///< as `high`; empty: zero

  std::size_t count() const { return high.size() / (unknowns + 1); }
};

struct Refined {
  std::vector<double> y;
  double residual_norm = 0.0;
  std::size_t steps = 0;
  bool converged = false;  ///< the last step changed no unknown by more than 4ε
};

/// The solution by the QR that identification uses (ident::Triangle, ident::solve_dense), refined: the residuals of the augmented
/// system r = p − Ey, Eᵀr = 0 are computed in 50 digits, the corrections in double precision, with QR of [E | r] (Björck 1967).
/// Each step gains 16 − log₁₀(condition) digits; without convergence the condition is above about 1e15.
Refined solve_refined(const Rows& rows, std::size_t most_steps = 30);

}  // namespace jointid::stability
