#include "ident/likelihood/line/frf_weight.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

double within_factor_two(double now, double before) {
  return std::isfinite(now) && now > 0.0 ? std::clamp(now, 0.5 * before, 2.0 * before) : before;
}

}  // namespace

std::complex<double> frf_weight(std::complex<double> variance, std::complex<double> value) {
  const double larger = std::max(variance.real(), variance.imag());
  const double least = std::max(1e-8 * larger, 1e-16 * std::norm(value));
  if (!(least > 0.0) || !std::isfinite(larger)) return 0.0;
  return {1.0 / std::sqrt(std::max(variance.real(), least)), 1.0 / std::sqrt(std::max(variance.imag(), least))};
}

std::complex<double> near_weight(std::complex<double> now, std::complex<double> before) {
  return {within_factor_two(now.real(), before.real()), within_factor_two(now.imag(), before.imag())};
}

}  // namespace jointid::ident
