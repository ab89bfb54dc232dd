#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "base/complex.hpp"

namespace jointid::impedance {

/// Elements of Z at a line with the covariance of their errors.
struct LineValue {
  Eigen::VectorXcd z;                ///< [T]
  Eigen::MatrixXd covariance;        ///< [2T × 2T], all real parts, then all imaginary ones
  double chi_square = std::nan("");  ///< of what is left; NaN: the way has none
  double freedom = 0.0;

  /// E|δz_t|².
  double variance(Eigen::Index t) const { return covariance(t, t) + covariance(z.size() + t, z.size() + t); }
  double re_error(Eigen::Index t) const { return std::sqrt(covariance(t, t)); }
  double im_error(Eigen::Index t) const { return std::sqrt(covariance(z.size() + t, z.size() + t)); }
};

/// Z = Σ_t z_t E_t over N joint coordinates, E_t real and symmetric.
using Basis = std::vector<Eigen::MatrixXd>;

/// Of all elements of a symmetric matrix of so many rows, upper triangle row by row.
Basis symmetric_basis(std::size_t size);

Eigen::MatrixXcd matrix_of(const Basis& basis, const Eigen::VectorXcd& z);

/// Upper triangle, row by row.
Eigen::VectorXcd triangle_of(const Eigen::MatrixXcd& z);

}  // namespace jointid::impedance
