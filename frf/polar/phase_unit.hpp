#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "frf/text/complex_text.hpp"

namespace jointid::frf {

/// The unit of phases by their numbers alone, where these leave no other.
class PhaseUnit {
 public:
  /// The phases of one FRF over all lines; what is not finite is left out.
  void add(std::span<const double> phases);

  /// From eight phases on. Degrees: beyond a turn in radians, with a step between two lines above a half turn in radians, which
  /// unwrapped radians do not have. Radians: bounded by ±π or [0, 2π] and close to that bound (3 or more, 6 or more), over 2.5 (5)
  /// in all. Else unstated.
  AngleUnit unit() const;

 private:
  std::size_t count_ = 0;
  double least_ = 0.0, most_ = 0.0, largest_step_ = 0.0;
};

/// "deg", "degrees", "°", "[rad]", "radians": a unit of phases as a file states it; unstated for any other text.
AngleUnit angle_unit(std::string_view label);

}  // namespace jointid::frf
