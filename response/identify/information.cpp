#include "response/identify/information.hpp"

#include <cmath>

#include "dense/svd.hpp"

namespace jointid::response {
namespace {

constexpr double least_seen = 1e-9, along_unseen = 1e-6;

}  // namespace

Information::Information(const Eigen::MatrixXd& jacobian) {
  scale_ = jacobian.colwise().norm().transpose();
  scale_ = (scale_.array() > 0.0).select(scale_, 1.0);
  const Eigen::MatrixXd scaled = jacobian * scale_.cwiseInverse().asDiagonal();
  const dense::RealSvd svd = dense::jacobi_svd(scaled, dense::Vectors::none, dense::Vectors::full);
  const double largest = svd.sigma.size() > 0 ? svd.sigma(0) : 0.0;
  const Eigen::Index rank = largest > 0.0 ? (svd.sigma.array() > least_seen * largest).count() : 0;
  const Eigen::MatrixXd seen =
      scale_.cwiseInverse().asDiagonal() * svd.v.leftCols(rank) * svd.sigma.head(rank).cwiseInverse().asDiagonal();
  unseen_ = svd.v.rightCols(scale_.size() - rank);
  covariance_ = seen * seen.transpose();
}

std::optional<double> Information::deviation(const Eigen::RowVectorXd& gradient) const {
  const Eigen::RowVectorXd scaled = gradient * scale_.cwiseInverse().asDiagonal();
  if ((scaled * unseen_).norm() > along_unseen * scaled.norm()) return std::nullopt;
  return std::sqrt((gradient * covariance_ * gradient.transpose()).value());
}

}  // namespace jointid::response
