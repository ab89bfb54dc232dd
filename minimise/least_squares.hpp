#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace jointid::minimise {

/// Residuals r(q) of a least-squares problem.
class LeastSquares {
 public:
  virtual ~LeastSquares() = default;
  virtual std::size_t unknowns() const = 0;
  virtual std::size_t residuals() const = 0;
  /// Fills r and, unless it is empty, the Jacobian [residuals, unknowns] row by row. Returns false if r is not defined at q.
  virtual bool evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const = 0;

  /// Σ r², or +infinity if r is not defined.
  double objective(std::span<const double> q) const;
};

struct Minimum {
  std::vector<double> q;
  std::size_t iterations = 0;
  bool converged = false;
};

/// Levenberg–Marquardt of Ceres, until a step lowers Σ r² by less than `tolerance` times its value. Without the module ceres it
/// throws InputError; see has_ceres().
struct CeresOptions {
  double tolerance = 1e-10;
  int most_iterations = 100;
  double parameter_tolerance = 1e-11;  ///< or a step is shorter than this times q
  double gradient_tolerance = 1e-14;   ///< or no element of the gradient is larger
};
Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options = {});
bool has_ceres();

/// A function without derivatives, to minimise; +infinity where it is not defined.
using Objective = std::function<double(std::span<const double> q)>;

/// Interior-point minimum of Σ r² by Ipopt with the Gauss–Newton Hessian 2JᵀJ, within lower ≤ q ≤ upper where given. One solve
/// runs at a time, others wait: Debian's Ipopt is not thread-safe. Without the module ipopt it throws InputError; see
/// has_ipopt().
struct IpoptOptions {
  double tolerance = 1e-10;
  int most_iterations = 100;
  std::vector<double> lower, upper;  ///< [unknowns], ±infinity for no bound; empty: no bounds
};
Minimum ipopt_minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options = {});
bool has_ipopt();

/// Pattern search of Hooke and Jeeves (docs/formulas.md §10f): exploratory moves along the axes, then pattern moves in the same
/// direction. The step is halved if none helps, until it is below `tolerance`.
struct PatternOptions {
  double step = 0.1;
  double tolerance = 1e-10;
  std::size_t most_evaluations = 200000;
};
Minimum pattern_search(const Objective& f, std::span<const double> start, const PatternOptions& options = {});

}  // namespace jointid::minimise
