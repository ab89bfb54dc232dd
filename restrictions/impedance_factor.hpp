#pragma once

#include <Eigen/Core>

#include "base/complex.hpp"
#include "restrictions/matrix_terms.hpp"

namespace jointid::restrictions {

/// Factor of matrix `kind` in Z_j(ω): 1, −ω², iω, i.
Complex impedance_factor(Kind kind, double omega);

/// Unknown in SI units = scaled unknown of x · this: 1, 1/ω₀², 1/ω₀, 1.
double unscale(Kind kind, double omega0);

/// Adds to Z_j(ω) (N/m) what a matrix of this kind (SI units) is of it: z += factor · matrix.
void add_impedance(Kind kind, const Eigen::Ref<const Eigen::MatrixXd>& matrix, double omega, Eigen::MatrixXcd& z);

}  // namespace jointid::restrictions
