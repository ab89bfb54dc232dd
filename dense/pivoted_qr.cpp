#include "dense/pivoted_qr.hpp"

#include <Eigen/QR>

namespace jointid::dense {

template <class Matrix>
struct PivotedQr<Matrix>::Factors {
  Eigen::ColPivHouseholderQR<Matrix> qr;
};

template <class Matrix>
PivotedQr<Matrix>::PivotedQr(const Eigen::Ref<const Matrix>& a, std::optional<double> threshold) {
  auto factors = std::make_shared<Factors>();
  if (threshold) factors->qr.setThreshold(*threshold);
  factors->qr.compute(a);
  factors_ = std::move(factors);
}

template <class Matrix>
Eigen::Index PivotedQr<Matrix>::rank() const {
  return factors_->qr.rank();
}

template <class Matrix>
typename PivotedQr<Matrix>::Vector PivotedQr<Matrix>::solve(const Eigen::Ref<const Vector>& b) const {
  return factors_->qr.solve(b);
}

template <class Matrix>
Matrix PivotedQr<Matrix>::triangle() const {
  const Matrix& qr = factors_->qr.matrixQR();
  return qr.topRows(std::min(qr.rows(), qr.cols())).template triangularView<Eigen::Upper>();
}

template <class Matrix>
const typename PivotedQr<Matrix>::Permutation& PivotedQr<Matrix>::permutation() const {
  return factors_->qr.colsPermutation();
}

template <class Matrix>
Matrix PivotedQr<Matrix>::orthonormal_columns(Eigen::Index count) const {
  return factors_->qr.householderQ() * Matrix::Identity(factors_->qr.rows(), count);
}

template <class Matrix>
Matrix PivotedQr<Matrix>::rotated(const Eigen::Ref<const Matrix>& b) const {
  return factors_->qr.householderQ().adjoint() * b;
}

template class PivotedQr<Eigen::MatrixXd>;
template class PivotedQr<Eigen::MatrixXcd>;

}  // namespace jointid::dense
