#pragma once

#include <cstddef>
#include <vector>

namespace jointid::minimise {

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
  /// ‖row j of E⁺‖₂: by so much, at most, y_j changes when the right-hand side changes by 1. With Condition::compute and full
  /// rank.
  std::vector<double> inverse_norms;
  /// Of y: first-order bound of what the rounding of the solver does, for the rows as they were pushed. As inverse_norms.
  std::vector<double> rounding;
};

}  // namespace jointid::minimise
