#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "impedance/line/error_columns.hpp"

namespace jointid::impedance {

/// The measured FRFs of a system at a line, and their errors.
struct MeasuredSystem {
  Eigen::MatrixXcd h;  ///< symmetric; NaN where not measured

  struct Frf {
    Eigen::Index row, column;  ///< row ≤ column
  };
  std::vector<Frf> frfs;
  ErrorColumns errors;  ///< of `frfs`
};

/// FRFs of B at a line with their errors to first order.
struct DecoupledLine {
  Eigen::MatrixXcd h;  ///< [u × u]
  Eigen::MatrixXd variance_re, variance_im;
  std::vector<Eigen::MatrixXcd> covariance;  ///< of the rows of each column, E[δ_r δ_s*]
  Eigen::VectorXd singular_values;           ///< of (H_AB − H_A)(v, e); empty for the likelihood
};

/// (23) with (24): H_B(u,u) = H_AB(u,u) − H_AB(u,e) [(H_AB − H_A)(v,e)]⁺ H_AB(v,u). `kept`: singular values, 0 for all. Of A the
/// places of v and e are given apart. All FRFs that it takes must be known.
struct DecoupleAt {
  std::vector<Eigen::Index> u, v, e;         ///< in AB
  std::vector<Eigen::Index> v_of_a, e_of_a;  ///< the same coordinates in A
  std::size_t kept = 0;
};
DecoupledLine decouple(const MeasuredSystem& whole, const MeasuredSystem& a, const DecoupleAt& at);

/// Y = Z⁻¹ with the covariance of Z, [2T × 2T] over its upper triangle: δY = −Y δZ Y.
DecoupledLine receptance_of(const Eigen::MatrixXcd& z, const Eigen::MatrixXd& covariance);

}  // namespace jointid::impedance
