#pragma once

#include "base/complex.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// Factor of matrix `kind` in Z_j(ω): 1, −ω², iω, i.
Complex impedance_factor(restrictions::Kind kind, double omega);

/// Unknown in SI units = scaled unknown of x · this: 1, 1/ω₀², 1/ω₀, 1.
double unscale(restrictions::Kind kind, double omega0);

}  // namespace jointid::ident
