#include "friction/path/cancellation_free.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace jointid::friction {
namespace {

/// first · Σ_n Π ratio(1…n), until it no longer changes.
template <class Ratio>
double series(double first, Ratio ratio) {
  double term = first, sum = first;
  for (int n = 1; std::abs(term) > 0.25 * std::numeric_limits<double>::epsilon() * std::abs(sum); ++n) {
    term *= ratio(n);
    sum += term;
  }
  return sum;
}

}  // namespace

double linear_minus_exponential(double x) {
  if (x > 1.0) return x + std::expm1(-x);
  return series(0.5 * x * x, [x](int n) { return -x / (n + 2); });
}

double exponential_excess(double x) {
  if (x > 1.0) return (x - 1.0) * std::exp(x) + 1.0;
  // Σ_{n≥2} xⁿ (n−1)/n!
  return series(0.5 * x * x, [x](int n) { return x * (n + 1) / (static_cast<double>(n) * (n + 2)); });
}

double damped_hyperbolic_excess(double x) {
  if (x > 1.0) return 0.5 * ((x - 1.0) + (x + 1.0) * std::exp(-2.0 * x));
  // Σ_{n≥1} x^{2n+1} 2n/(2n+1)!
  return std::exp(-x) * series(x * x * x / 3.0, [x](int n) { return x * x / (n * (2.0 * n + 3.0) * 2.0); });
}

double exponential_second_moment(double x) {
  if (x > 2.0) return x * x * x / 3.0 + std::exp(-x) * (x * x + 2.0 * x + 2.0) - 2.0;
  // Σ_{n≥1} (−1)^{n+1} x^{n+3}/(n!(n+3))
  return series(x * x * x * x / 4.0, [x](int n) { return -x * (n + 3) / ((n + 1.0) * (n + 4)); });
}

double circular_segment(double x) {
  if (x > 0.5) return x - 0.5 * std::sin(2.0 * x);
  const double y = 4.0 * x * x;
  return series(y * x / 6.0, [y](int n) { return -y / ((2.0 * n + 2.0) * (2.0 * n + 3.0)); });
}

double scaled_bessel_i1(double x) {
  if (x < 40.0) return std::exp(-x) * std::cyl_bessel_i(1.0, x);
  // Hankel's expansion; its terms decrease until n ≈ 2x.
  return series(1.0, [x](int n) { return ((2.0 * n - 1.0) * (2.0 * n - 1.0) - 4.0) / (8.0 * x * n); }) /
         std::sqrt(2.0 * std::numbers::pi * x);
}

}  // namespace jointid::friction
