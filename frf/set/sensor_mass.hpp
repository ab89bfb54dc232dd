#pragma once

#include "frf/set/dof.hpp"

namespace jointid::frf {

/// A number that belongs to a DOF: the mass of a sensor, a gain.
struct DofNumber {
  Dof dof;
  double value = 0.0;
};

/// Which sensors' masses were on the structure while a response was measured.
enum class SensorsOn {
  roving,    ///< that of the response's own DOF
  triaxial,  ///< those of the response's node
  fixed      ///< all
};

}  // namespace jointid::frf
