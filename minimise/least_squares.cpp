#include "minimise/least_squares.hpp"

#include <limits>

namespace jointid::minimise {

double LeastSquares::objective(std::span<const double> q) const {
  std::vector<double> r(residuals());
  if (!evaluate(q, r, {})) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const double each : r) sum += each * each;
  return sum;
}

}  // namespace jointid::minimise
