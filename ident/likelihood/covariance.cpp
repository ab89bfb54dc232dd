#include "ident/likelihood/covariance.hpp"

#include <Eigen/Eigenvalues>

namespace jointid::ident {

namespace {

constexpr double singular = 1e-12;

/// Scales the diagonal to 1; unknowns without information keep 0.
Eigen::VectorXd scales_of(const Eigen::MatrixXd& information) {
  return information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
}

}  // namespace

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information) {
  const Eigen::VectorXd scale = scales_of(information);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const double least = 1e-15 * static_cast<double>(information.rows());
  const Eigen::MatrixXd vectors = scale.asDiagonal() * eigen.eigenvectors();
  return vectors * eigen.eigenvalues().cwiseMax(least).cwiseInverse().asDiagonal() * vectors.transpose();
}

Eigen::MatrixXd null_space_of(const Eigen::MatrixXd& information) {
  const Eigen::VectorXd scale = scales_of(information);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const auto count = (eigen.eigenvalues().array() < singular).count();
  return scale.asDiagonal() * eigen.eigenvectors().leftCols(count);
}

}  // namespace jointid::ident
