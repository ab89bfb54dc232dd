#include "dense/lu.hpp"

#include <Eigen/LU>

namespace jointid::dense {

using Eigen::MatrixXcd;

struct ComplexLu::Factors {
  Eigen::PartialPivLU<MatrixXcd> lu;
};

ComplexLu::ComplexLu(const Eigen::Ref<const MatrixXcd>& a)
    : factors_(std::make_shared<const Factors>(Factors{Eigen::PartialPivLU<MatrixXcd>(a)})) {}

MatrixXcd ComplexLu::solve(const Eigen::Ref<const MatrixXcd>& b) const { return factors_->lu.solve(b); }

MatrixXcd ComplexLu::inverse() const { return factors_->lu.inverse(); }

double ComplexLu::reciprocal_condition() const {
  const auto& lu = factors_->lu;
  if (lu.rows() == 0) return 1.0;
  return lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0.0 ? lu.rcond() : 0.0;  // Eigen's estimate cannot be trusted at a pivot of 0
}

MatrixXcd solve(const Eigen::Ref<const MatrixXcd>& a, const Eigen::Ref<const MatrixXcd>& b) {
  return Eigen::PartialPivLU<MatrixXcd>(a).solve(b);
}

MatrixXcd inverse(const Eigen::Ref<const MatrixXcd>& a) { return Eigen::PartialPivLU<MatrixXcd>(a).inverse(); }

Eigen::Matrix4d inverse_4x4(const Eigen::Matrix4d& a) { return a.inverse(); }

}  // namespace jointid::dense
