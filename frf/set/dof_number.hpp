#pragma once

#include "frf/set/dof.hpp"

namespace jointid::frf {

/// A number that belongs to a DOF.
struct DofNumber {
  Dof dof;
  double value = 0.0;
};

}  // namespace jointid::frf
