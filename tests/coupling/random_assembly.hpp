#pragma once

#include <rapidcheck.h>

#include <cmath>

#include "coupling/condition.hpp"

namespace jointid::coupling {

/// Some structures by dynamic stiffness, and conditions between their coordinates. Coordinates that conditions name come first.
struct RandomAssembly {
  ComplexMatrix h;                ///< of all structures side by side
  ComplexMatrix assembled;        ///< T (Tᵀ Z T)⁻¹ Tᵀ, from the stiffness matrices, never from h
  Conditions conditions;
  std::vector<std::size_t> body;  ///< of each coordinate
};

struct Shape {
  bool symmetric = true;
  bool across_only = false;  ///< conditions only between two structures, no ground: what receptance coupling can do
  bool pairs_only = false;   ///< no coordinate in two conditions
};

/// 2–6 structures of 2–5 coordinates.
RandomAssembly random_assembly(const Shape& shape);

}  // namespace jointid::coupling
