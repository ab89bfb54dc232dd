#pragma once

#include <cstddef>

#include "base/complex.hpp"

namespace jointid::restrictions {

/// Of ∂Z/∂θ.
struct ImpedanceTerm {
  std::size_t row, column;
  double coefficient;
};

/// Terms that unknowns of several kinds have in common, and which of the parts these are.
struct ImpedanceShape {
  std::size_t first_term, last_term, first_part, last_part;
};

/// ∂Z/∂θ_unknown = factor · shape.
struct ImpedancePart {
  Complex factor;
  std::size_t unknown;
};

}  // namespace jointid::restrictions
