#include <cmath>
#include <nlopt.hpp>

#include "friction/least_squares.hpp"

namespace jointid::friction {
namespace {

/// The larger value that stands for "not defined": DIRECT needs finite numbers.
constexpr double undefined = 1e100;

double value(const std::vector<double>& q, std::vector<double>&, void* problem) {
  const double objective = static_cast<const LeastSquares*>(problem)->objective(q);
  return std::isfinite(objective) ? objective : undefined;
}

}  // namespace

bool has_nlopt() { return true; }

std::vector<double> nlopt_global(const LeastSquares& problem, std::span<const double> start, double half_width, int evaluations) {
  std::vector<double> q(start.begin(), start.end()), lower = q, upper = q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    lower[i] -= half_width;
    upper[i] += half_width;
  }
  nlopt::opt search(nlopt::GN_DIRECT_L, static_cast<unsigned>(q.size()));
  search.set_lower_bounds(lower);
  search.set_upper_bounds(upper);
  search.set_min_objective(value, const_cast<LeastSquares*>(&problem));
  search.set_maxeval(evaluations);
  double least = 0.0;
  search.optimize(q, least);
  return least < problem.objective(start) ? q : std::vector<double>(start.begin(), start.end());
}

}  // namespace jointid::friction
