#include "oscillation/integrate/first_root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace jointid::oscillation {
namespace {

constexpr std::size_t most = 40;
using Coefficients = std::array<double, most>;

double value(const Coefficients& c, std::size_t n, double t) {
  double sum = 0.0;
  for (std::size_t k = n; k-- > 0;) sum = sum * t + c[k];
  return sum;
}

/// Root in [0, 1] of p, falling from p(0) > 0 to p(1) ≤ 0: Newton within a bracket.
double falling_root(const Coefficients& c, std::size_t n) {
  double low = 0.0, high = 1.0, t = 0.5;
  for (int k = 0; k < 200; ++k) {
    double p = 0.0, slope = 0.0;
    for (std::size_t j = n; j-- > 0;) slope = slope * t + p, p = p * t + c[j];
    (p > 0.0 ? low : high) = t;
    double next = t - p / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-16 || high - low <= 1e-16) return next;
    t = next;
  }
  return t;
}

/// p(a + bt).
Coefficients moved(Coefficients c, std::size_t n, double a, double b) {
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (std::size_t j = n - 1; j-- > i;) c[j] += a * c[j + 1];
  }
  double power = 1.0;
  for (std::size_t k = 0; k < n; ++k, power *= b) c[k] *= power;
  return c;
}

/// The first place in [0, 1] with p ≤ 0 where p(0) > 0; `rounding`: what of p is noise.
std::optional<double> search(const Coefficients& c, std::size_t n, double rounding, int depth) {
  double rest = 0.0, bent = 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    rest += std::min(c[k], 0.0);
    if (k > 1) bent += static_cast<double>(k) * std::abs(c[k]);
  }
  if (c[0] + rest > 0.0) return std::nullopt;
  const double end = value(c, n, 1.0);
  if (n > 1 && std::abs(c[1]) > bent) {  // p' keeps its sign
    if (end > 0.0) return std::nullopt;
    return falling_root(c, n);
  }
  if (depth == 0 || c[0] <= rounding) return end > 0.0 && c[0] > rounding ? std::optional<double>() : std::optional<double>(0.0);
  if (const auto left = search(moved(c, n, 0.0, 0.5), n, rounding, depth - 1)) return 0.5 * *left;
  const Coefficients right = moved(c, n, 0.5, 0.5);
  if (right[0] <= 0.0) return 0.5;
  if (const auto found = search(right, n, rounding, depth - 1)) return 0.5 + 0.5 * *found;
  return std::nullopt;
}

}  // namespace

std::optional<double> first_root(std::span<const double> coefficients, double length) {
  const std::size_t n = std::min(coefficients.size(), most);
  if (n == 0) return std::nullopt;
  if (coefficients[0] <= 0.0) return 0.0;
  Coefficients c{};
  double power = 1.0, size = 0.0, below = 0.0;
  for (std::size_t k = 0; k < n; ++k, power *= length) {
    c[k] = coefficients[k] * power;
    size += std::abs(c[k]);
    if (k > 0) below += std::min(c[k], 0.0);
  }
  if (c[0] + below > 0.0) return std::nullopt;
  const auto found = search(c, n, 1e-18 * size, 50);
  return found ? std::optional<double>(*found * length) : std::nullopt;
}

}  // namespace jointid::oscillation
