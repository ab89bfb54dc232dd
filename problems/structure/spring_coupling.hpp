#pragma once

#include <complex>
#include <vector>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// A spring between two DOFs with its complex stiffness k + id.
struct ComplexSpring {
  restrictions::Spring ends;
  std::complex<double> stiffness;  ///< N/m
};

/// Sets of parts, square over their DOFs and on one axis, as one set: FRFs between two parts are zero.
frf::FrfSet side_by_side(const std::vector<frf::FrfSet>& parts);

/// The FRFs with the springs between the DOFs of a square set, one after the other (Sherman and Morrison 1950):
/// H ← H − z (Hb)(bᵀH)/(1 + z bᵀHb) with b the ends of the spring, +1 and −1. Exact up to rounding.
frf::FrfSet with_springs(frf::FrfSet set, const std::vector<ComplexSpring>& springs);

}  // namespace jointid::problems
