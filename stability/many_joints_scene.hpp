#pragma once

#include "stability/extreme_scene.hpp"

namespace jointid::stability {

/// Beams on many joints whose stiffness goes in equal ratios from 1/spread to `spread` times the built-in problems', soft and stiff ones
/// beside each other; motion at all coordinates and a few forces, so that Method One has rows by parts. Noise-free.
struct ManyJointsScene {
  bool frame = false;        ///< a plane frame of 12 beams on 9 nodes and 3 legs, else a row of 27 beams
  double spread = 1.0;
  bool definite = false;     ///< K and D positive semidefinite, and every other joint without damping: its D is on the edge
};

ExtremeProblem make(const ManyJointsScene& scene);

}  // namespace jointid::stability
