#pragma once

#include "base/complex.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// What LineModel has of a line: P, P Y, Z A, hᵀ = PᵀZᵀX, X − Yᵀhᵀ, R, and where B is measured I − Z B and Y − B − Y Z B.
struct LineFactors {
  const ComplexMatrix &p, &py, &za, &h, &yh, &r, &c, &rest_b;
};

}  // namespace jointid::ident
