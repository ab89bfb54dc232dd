#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// Q with the columns' span of a tall matrix of full rank, by Householder reflections without pivoting.
Eigen::MatrixXd orthonormal_columns(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// R of A = Q R: square, upper triangular; rows ≥ columns.
Eigen::MatrixXd triangle_of(const Eigen::Ref<const Eigen::MatrixXd>& a);

}  // namespace jointid::dense
