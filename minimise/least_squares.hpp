#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace jointid::minimise {

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

/// Levenberg–Marquardt of Ceres, until a step lowers Σ r² by less than `tolerance` times it. Without the module
/// ceres it throws InputError; has_ceres() says whether it is there.
struct CeresOptions {
  double tolerance = 1e-10;
  int most_iterations = 100;
  double parameter_tolerance = 1e-11;  ///< or a step is shorter than this times q
  double gradient_tolerance = 1e-14;   ///< or no element of the gradient is larger
};
Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options = {});
bool has_ceres();

/// What is made small where only values are known; +infinity where it is not defined.
using Objective = std::function<double(std::span<const double> q)>;

/// The same with its gradient, which is filled unless it is empty.
using Slopes = std::function<double(std::span<const double> q, std::span<double> gradient)>;

/// Searches of NLopt.
enum class Search {
  direct,  ///< DIRECT-L: divides the box again and again; no derivatives
  mlsl,    ///< multi-level single linkage: SLSQP from a low-discrepancy sequence of starts
  slsqp    ///< sequential quadratic programming, from the start only
};

/// Best point that a search finds in the box start ± half_width; the start where it finds
/// none better. `converged` when it ended by its tolerance, which of these only slsqp does. Without the module nlopt it
/// throws InputError; has_nlopt() says whether it is there.
struct NloptOptions {
  Search search = Search::direct;
  double half_width = 1.0;
  int evaluations = 10000;
  double tolerance = 0.0;  ///< relative, of every unknown; 0: all evaluations are used
};
Minimum nlopt_minimum(const Objective& objective, std::span<const double> start, const NloptOptions& options);
Minimum nlopt_minimum(const Slopes& objective, std::span<const double> start, const NloptOptions& options);
bool has_nlopt();

/// Interior-point minimum of Σ r² by Ipopt with the Gauss–Newton Hessian 2JᵀJ, within lower ≤ q ≤ upper where given. One solve at a
/// time runs, others wait: Debian's Ipopt is not thread-safe. Without the
/// module ipopt it throws InputError; has_ipopt() says whether it is there.
struct IpoptOptions {
  double tolerance = 1e-10;
  int most_iterations = 100;
  std::vector<double> lower, upper;  ///< [unknowns], ±infinity where there is none; empty: none
};
Minimum ipopt_minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options = {});
bool has_ipopt();

/// Pattern search of Hooke and Jeeves (docs/formulas.md §10f): exploratory moves along the axes, then moves along the way that they went;
/// the step is halved when none helps, until it is below `tolerance`.
struct PatternOptions {
  double step = 0.1;
  double tolerance = 1e-10;
  std::size_t most_evaluations = 200000;
};
Minimum pattern_search(const Objective& f, std::span<const double> start, const PatternOptions& options = {});

}  // namespace jointid::minimise
