#include "minimise/linear/covariance.hpp"

#include "dense/eigen.hpp"

namespace jointid::minimise {

namespace {

constexpr double singular = 1e-12;

/// Information with its diagonal scaled to 1 (0 for unknowns without information): diag(scale) · information · diag(scale).
struct Scaled {
  explicit Scaled(const Eigen::MatrixXd& information)
      : scale(information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse()),
        eigen(dense::symmetric_eigen(scale.asDiagonal() * information * scale.asDiagonal())),
        null_dimension((eigen.values.array() < singular).count()) {}

  Eigen::VectorXd scale;
  dense::SymmetricEigen eigen;
  Eigen::Index null_dimension;
};

}  // namespace

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information) {
  const Scaled scaled(information);
  const double least = 1e-15 * static_cast<double>(information.rows());
  const Eigen::MatrixXd vectors = scaled.scale.asDiagonal() * scaled.eigen.vectors;
  return vectors * scaled.eigen.values.cwiseMax(least).cwiseInverse().asDiagonal() * vectors.transpose();
}

Eigen::MatrixXd root_of(const Eigen::MatrixXd& information) {
  const Scaled scaled(information);
  return scaled.eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() * scaled.eigen.vectors.transpose() *
         scaled.scale.cwiseInverse().asDiagonal();
}

Eigen::MatrixXd null_space_of(const Eigen::MatrixXd& information) {
  const Scaled scaled(information);
  return scaled.scale.asDiagonal() * scaled.eigen.vectors.leftCols(scaled.null_dimension);
}

Eigen::VectorXd determined_step(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) {
  const Scaled scaled(information);
  const Eigen::Index rank = information.rows() - scaled.null_dimension;
  const Eigen::MatrixXd vectors = scaled.scale.asDiagonal() * scaled.eigen.vectors.rightCols(rank);
  return vectors * scaled.eigen.values.tail(rank).cwiseInverse().asDiagonal() * (vectors.transpose() * gradient);
}

}  // namespace jointid::minimise
