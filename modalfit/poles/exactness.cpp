#include "modalfit/poles/exactness.hpp"

#include <cmath>

namespace jointid::modalfit {

double weighted_square(const Band& band, const std::vector<std::size_t>& entries) {
  double sum = 0.0;
  for (const std::size_t entry : entries) {
    const double* parts = reinterpret_cast<const double*>(band.value(entry));
    for (std::size_t i = 0; i < 2 * band.lines(); ++i) sum += std::pow(parts[i] * band.weights(entry)[i], 2.0);
  }
  return sum;
}

bool is_exact(const Band& band, const std::vector<std::size_t>& entries, const RefinedPoles& refined) {
  return refined.cost <= nearly_exact * nearly_exact * weighted_square(band, entries);
}

}  // namespace jointid::modalfit
