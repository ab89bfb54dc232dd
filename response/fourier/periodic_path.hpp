#pragma once

#include <vector>

#include "friction/path/element.hpp"
#include "response/fourier/motion.hpp"

namespace jointid::response {

/// Where the motion turned, or its largest |q|.
struct PathCorner {
  double theta = 0.0, displacement = 0.0, force = 0.0;
  int parent = -1;     ///< the corner of the branch on which it was reached; −1: the initial curve
  int direction = +1;  ///< in which it was reached
};

/// A monotone stretch of the motion on the branch f = F_c + 2sT(s(q − q_c)/2) of its corner c, s the direction.
struct PathStretch {
  int corner = 0;
  int direction = +1;
  double from = 0.0, to = 0.0;  ///< θ
};

/// The periodic state of an element that obeys Masing's rule, free of residual force: on the initial curve at the largest |q|,
/// from there branches, closed loops forgotten.
struct PeriodicPath {
  std::vector<PathCorner> corners;
  std::vector<PathStretch> stretches;
  bool half = false;  ///< odd harmonics alone: half a period, the other half is its negative
  int reversals = 0;  ///< in a whole period
};

/// Empty (no corners) when the motion does not turn.
PeriodicPath periodic_path(const friction::Element& element, const Motion& motion);

}  // namespace jointid::response
