#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// Q with the columns' span of a tall matrix of full rank, by Householder reflections without pivoting.
Eigen::MatrixXd orthonormal_columns(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// R of A = Q R: square, upper triangular; rows ≥ columns.
Eigen::MatrixXd triangle_of(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// What least squares over X leaves of AX + B: with A = Q R (rows ≥ columns, full rank) QᵀB is split, so that X = −R⁻¹·taken and
/// ‖AX + B‖² = ‖left‖² at the minimum.
struct Elimination {
  Eigen::MatrixXd triangle;  ///< R
  Eigen::MatrixXd taken;     ///< the first A.cols() rows of QᵀB
  Eigen::MatrixXd left;      ///< the others
};
Elimination eliminate(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace jointid::dense
