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

double deviation(const Band& band, const std::vector<std::size_t>& entries, const RefinedPoles& refined) {
  return std::sqrt(refined.cost / weighted_square(band, entries));
}

bool is_exact(const Band& band, const std::vector<std::size_t>& entries, const RefinedPoles& refined) {
  return deviation(band, entries, refined) <= nearly_exact;
}

}  // namespace jointid::modalfit
