#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/complex.hpp"
#include "models/structure_matrices.hpp"

namespace jointid::models {

/// The dynamic stiffness in its simplest form: Z(ω) = α(ω) K + β(ω) M + E R(ω) Eᵀ with α = 1 + i(η + d_K) + iω c_K,
/// β = −ω² + iω c_M + i d_M and R = iω R_C + i R_D, where C = c_M M + c_K K + E R_C Eᵀ and D = d_M M + d_K K + E R_D Eᵀ.
struct ProportionalForm {
  double loss = 0.0;  ///< η + d_K
  double d_m = 0.0, c_k = 0.0, c_m = 0.0;
  std::vector<std::size_t> dampers;  ///< the coordinates of E
  Eigen::MatrixXd rest_c, rest_d;    ///< R_C, R_D

  Complex alpha(double omega) const { return {1.0, loss + omega * c_k}; }
  Complex beta(double omega) const { return {-omega * omega, omega * c_m + d_m}; }
  Eigen::MatrixXcd rest(double omega) const { return Complex(0.0, omega) * rest_c + Complex(0.0, 1.0) * rest_d; }
};

/// Nothing where C and D differ from combinations of K and M at more than `most_dampers` coordinates.
std::optional<ProportionalForm> proportional_form(const StructureMatrices& matrices, std::size_t most_dampers);

}  // namespace jointid::models
