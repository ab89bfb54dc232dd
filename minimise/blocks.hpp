#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace jointid::minimise {

/// Residuals r(p₁, p₂, …) of several blocks of parameters.
class ResidualBlock {
 public:
  virtual ~ResidualBlock() = default;
  virtual std::size_t residuals() const = 0;
  /// How many parameters each block has.
  virtual std::vector<std::size_t> sizes() const = 0;
  /// Fills r and, where it is not null, the Jacobian [residuals, size] of a block row by row; `jacobians` itself may be null.
  /// False where r is not defined.
  virtual bool evaluate(const double* const* parameters, double* r, double** jacobians) const = 0;
};

/// ρ(s) of s = ‖r‖²: its value and its first two derivatives.
class Loss {
 public:
  virtual ~Loss() = default;
  virtual void evaluate(double s, double rho[3]) const = 0;
};

/// One residual block, its loss (null: ρ(s) = s) and its parameters, which are changed in place.
struct BlockTerm {
  const ResidualBlock* block = nullptr;
  const Loss* loss = nullptr;
  std::vector<double*> parameters;
};

struct BlockOptions {
  double* constant = nullptr;  ///< parameters that stay
  double* common = nullptr;    ///< of every term: all others are eliminated first (Schur complement); null: dense QR
  int most_iterations = 50;
  double function_tolerance = 1e-6;
  double parameter_tolerance = 1e-8;
  double gradient_tolerance = 1e-10;
  std::function<void()> after_iteration = {};  ///< ends the search by throwing
};

struct BlockMinimum {
  double cost = 0.0;  ///< Σ ρ
  bool converged = false;
};

/// Levenberg–Marquardt of Ceres for Σ ρ(‖r‖²), on one thread: sums of several would depend on their timing.
/// Throws InputError without the module ceres.
BlockMinimum ceres_blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options);

}  // namespace jointid::minimise
