#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace jointid::oscillation {

/// Where a curve y(x) is a straight line: x increasing.
struct Plateau {
  double slope = 0.0;
  double spread = 0.0;              ///< largest deviation of a third's own slope from `slope`
  std::size_t first = 0, last = 0;  ///< samples of the curve, both included
};

struct PlateauOptions {
  std::size_t least_points = 9;  ///< ≥ 6
  double least_rise = 1.0;       ///< of y over the plateau
  double tolerance = 0.15;       ///< slopes of the plateau's thirds differ from the whole's by at most this share of it
};

/// The longest stretch (by x) whose thirds have the slope of the whole and which rises enough; empty where there is none: then
/// the curve has no slope, only a number of slopes. Curves of equal points in x are assumed. Points that are not finite end a
/// stretch.
std::optional<Plateau> find_plateau(std::span<const double> x, std::span<const double> y, const PlateauOptions& options = {});

/// Slope of the least-squares line.
double line_slope(std::span<const double> x, std::span<const double> y);

}  // namespace jointid::oscillation
