#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace jointid::friction {

/// Residuals r(q) whose sum of squares is made small.
class LeastSquares {
 public:
  virtual ~LeastSquares() = default;
  virtual std::size_t unknowns() const = 0;
  virtual std::size_t residuals() const = 0;
  /// Fills r and, unless it is empty, the Jacobian [residuals, unknowns] row by row. False where r is not defined.
  virtual bool evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const = 0;

  /// Σ r², +infinity where r is not defined.
  double objective(std::span<const double> q) const;
};

struct Minimum {
  std::vector<double> q;
  std::size_t iterations = 0;
  bool converged = false;
};

/// Levenberg–Marquardt of Ceres, until a step lowers Σ r² by less than `tolerance` times it. A build without Ceres throws
/// std::logic_error; has_ceres() says which it is.
struct CeresOptions {
  double tolerance = 1e-10;
  int most_iterations = 100;
  double parameter_tolerance = 1e-11;  ///< or a step is shorter than this times q
  double gradient_tolerance = 1e-14;   ///< or no element of the gradient is larger
};
Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options = {});
bool has_ceres();

/// Best point of the box start ± half_width that NLopt's DIRECT-L finds in `evaluations`. A build without NLopt throws
/// std::logic_error; has_nlopt() says which it is.
std::vector<double> nlopt_global(const LeastSquares& problem, std::span<const double> start, double half_width, int evaluations);
bool has_nlopt();

/// Pattern search of Hooke and Jeeves (thesis §2.13): exploratory moves along the axes, then moves along the way that they went;
/// the step is halved when none helps, until it is below `tolerance`.
struct PatternOptions {
  double step = 0.1;
  double tolerance = 1e-10;
  std::size_t most_evaluations = 200000;
};
Minimum pattern_search(const std::function<double(std::span<const double>)>& f, std::span<const double> start,
                       const PatternOptions& options = {});

}  // namespace jointid::friction
