#include "oscillation/measurement/beam_shapes.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"

namespace jointid::oscillation {
namespace {

/// Newton on cos z + 1/cosh z from (j − ½)π, where it is nearly linear.
double clamped_free_root(std::size_t j) {
  double z = (static_cast<double>(j) - 0.5) * std::numbers::pi;
  for (int k = 0; k < 50; ++k) {
    const double step = (std::cos(z) + 1.0 / std::cosh(z)) / (-std::sin(z) - std::tanh(z) / std::cosh(z));
    z -= step;
    if (std::abs(step) <= 1e-16 * z) break;
  }
  return z;
}

/// cosh ξ − cos ξ − σ(sinh ξ − sin ξ) and two derivatives by ξ = βx. The growing part is ½(1 − σ)e^ξ with
/// 1 − σ = (sin z − cos z − e^{−z})/(sinh z + sin z).
Deflection clamped_free(double z, double xi) {
  const double one_less = (std::sin(z) - std::cos(z) - std::exp(-z)) / (std::sinh(z) + std::sin(z));
  const double sigma = 1.0 - one_less;
  const double grows = 0.5 * one_less * std::exp(xi), falls = 0.5 * (1.0 + sigma) * std::exp(-xi);
  const double c = std::cos(xi), s = std::sin(xi);
  return {grows + falls - c + sigma * s, grows - falls + s + sigma * c, grows + falls + c - sigma * s};
}

}  // namespace

std::vector<double> clamped_free_roots(std::size_t count) {
  std::vector<double> roots;
  for (std::size_t j = 1; j <= count; ++j) roots.push_back(clamped_free_root(j));
  return roots;
}

Deflection deflection(const Shape& shape, double length, double x) {
  switch (shape.kind) {
    case ShapeKind::tip_force:
      return {x * x * (3.0 * length - x) / 6.0, x * (2.0 * length - x) / 2.0, length - x};
    case ShapeKind::tip_moment:
      return {x * x / 2.0, x, 1.0};
    case ShapeKind::mode:
      break;
  }
  const double z = clamped_free_root(shape.mode), beta = z / length;
  const Deflection at = clamped_free(z, beta * x);
  return {at.value, beta * at.slope, beta * beta * at.curvature};
}

std::vector<Shape> beam_basis(std::size_t count, bool static_shapes) {
  if (count < (static_shapes ? 3u : 1u)) {
    throw InputError(
        {ErrorKind::usage, "", "shapes", std::to_string(count) + " are too few", "take at least 3 with static shapes"});
  }
  std::vector<Shape> basis;
  for (std::size_t j = 1; j <= count - (static_shapes ? 2 : 0); ++j) basis.push_back({ShapeKind::mode, j});
  if (static_shapes) basis.insert(basis.end(), {Shape{ShapeKind::tip_force, 0}, Shape{ShapeKind::tip_moment, 0}});
  return basis;
}

}  // namespace jointid::oscillation
