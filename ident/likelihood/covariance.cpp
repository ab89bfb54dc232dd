#include "ident/likelihood/covariance.hpp"

#include <Eigen/Eigenvalues>

namespace jointid::ident {

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information) {
  const Eigen::VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const double least = 1e-15 * static_cast<double>(information.rows());
  const Eigen::MatrixXd vectors = scale.asDiagonal() * eigen.eigenvectors();
  return vectors * eigen.eigenvalues().cwiseMax(least).cwiseInverse().asDiagonal() * vectors.transpose();
}

}  // namespace jointid::ident
