#include "modalfit/model/mac.hpp"

#include <cassert>

namespace jointid::modalfit {

double mac(std::span<const std::complex<double>> one, std::span<const std::complex<double>> other) {
  assert(one.size() == other.size());
  std::complex<double> product = 0.0;
  double first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    product += std::conj(one[i]) * other[i];
    first += std::norm(one[i]);
    second += std::norm(other[i]);
  }
  return std::norm(product) / (first * second);
}

}  // namespace jointid::modalfit
