#include "dense/qr.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace jointid::dense {

using Eigen::MatrixXd;

MatrixXd orthonormal_columns(const Eigen::Ref<const MatrixXd>& a) {
  const Eigen::HouseholderQR<MatrixXd> qr(a);
  return qr.householderQ() * MatrixXd::Identity(a.rows(), a.cols());
}

MatrixXd triangle_of(const Eigen::Ref<const MatrixXd>& a) {
  const Eigen::HouseholderQR<MatrixXd> qr(a);
  return qr.matrixQR().topRows(a.cols()).triangularView<Eigen::Upper>();
}

Elimination eliminate(const Eigen::Ref<const MatrixXd>& a, const Eigen::Ref<const MatrixXd>& b) {
  const Eigen::HouseholderQR<MatrixXd> qr(a);
  MatrixXd turned = b;
  constexpr Eigen::Index panel = 32;  // columns that all reflections find in the cache
  for (Eigen::Index c = 0; c < turned.cols(); c += panel)
    turned.middleCols(c, std::min(panel, turned.cols() - c)).applyOnTheLeft(qr.householderQ().adjoint());
  return {qr.matrixQR().topRows(a.cols()).triangularView<Eigen::Upper>(), turned.topRows(a.cols()),
          turned.bottomRows(a.rows() - a.cols())};
}

}  // namespace jointid::dense
