#pragma once

#include "ident/likelihood/line/line_tolerance.hpp"

namespace jointid::ident {

/// Loss L of a line: χ² up to 1.5² redundancies, then 2·1.5² − 1.5⁴/ρ² of them, ρ² = χ²/redundancy.
inline double robust_loss(double cost, double redundancy) {
  const double ratio = cost / redundancy;
  return redundancy * (ratio <= outlying ? ratio : 2.0 * outlying - outlying * outlying / ratio);
}

/// dL/dχ²: 1 for lines that fit, (1.5/ρ)⁴ beyond.
inline double robust_weight(double cost, double redundancy) {
  const double ratio = cost / redundancy;
  return ratio <= outlying ? 1.0 : (outlying / ratio) * (outlying / ratio);
}

}  // namespace jointid::ident
