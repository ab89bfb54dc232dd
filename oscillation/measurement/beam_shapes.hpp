#pragma once

#include <cstddef>
#include <vector>

namespace jointid::oscillation {

/// A deflection y(x) of a beam and its curvature y''(x).
struct Deflection {
  double value = 0.0, slope = 0.0, curvature = 0.0;
};

/// Which shape of a beam of length L, clamped at x = 0 and free at x = L.
enum class ShapeKind {
  mode,        ///< the j-th clamped-free mode, ∫φ² dx = L, φ(L) = 2, −2, 2, …
  tip_force,   ///< x²(3L − x)/6, y'' = L − x
  tip_moment,  ///< x²/2, y'' = 1
};
struct Shape {
  ShapeKind kind = ShapeKind::mode;
  std::size_t mode = 1;  ///< j ≥ 1 of `mode`
};

/// βL of the first `count` clamped-free modes: 1 + cos z cosh z = 0.
std::vector<double> clamped_free_roots(std::size_t count);

/// 0 ≤ x ≤ L, m. Modes without the cancellation of cosh and sinh.
Deflection deflection(const Shape& shape, double length, double x);

/// Modes 1 … count; or 1 … count − 2 and the shapes of a tip force and a tip moment, in which a static load at the tip is exact.
std::vector<Shape> beam_basis(std::size_t count, bool static_shapes);

}  // namespace jointid::oscillation
