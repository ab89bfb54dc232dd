#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// A V = V diag(values), values ascending.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< orthonormal; of the generalised problem VᵀMV = I
};

/// Of a symmetric matrix, of which the lower triangle is read.
SymmetricEigen symmetric_eigen(const Eigen::Ref<const Eigen::MatrixXd>& a);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// K V = M V diag(values), K symmetric, M symmetric and positive definite.
SymmetricEigen symmetric_eigen(const Eigen::Ref<const Eigen::MatrixXd>& k, const Eigen::Ref<const Eigen::MatrixXd>& m);

/// Of any real square matrix, by the QR algorithm.
Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& a);

}  // namespace jointid::dense
