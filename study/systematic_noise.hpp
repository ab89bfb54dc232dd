#pragma once

#include <string>

#include "base/random.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::study {

/// Gains and masses of roving sensors, normal and drawn anew in every trial, one per DOF: the same in all sets of a trial. A mass
/// m at the response p makes H(p,:)/(1 − ω²m H(p,p)) of its row, and a gain e^z divides it. Rotations have no mass.
struct SystematicNoise {
  double gain = 0.0;  ///< standard deviation of z
  double mass = 0.0;  ///< kg

  bool any() const { return gain > 0.0 || mass > 0.0; }

  /// `set`: without other errors; `stream.set` is not used. Rows whose H(p,p) the set does not have keep their mass off.
  void apply(frf::FrfSet& set, const RandomStream& stream) const;
};

/// The first translational response whose driving point the header lacks, or empty.
std::string without_driving_point(const frf::FrfHeader& header);

}  // namespace jointid::study
