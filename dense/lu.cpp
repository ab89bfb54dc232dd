#include "dense/lu.hpp"

#include <Eigen/LU>
#include <complex>

#include "base/kernel.hpp"

namespace jointid::dense {

using Eigen::MatrixXcd;

namespace {

/// Up to here elimination without blocks is faster.
constexpr Eigen::Index few = 8;

using Complex = std::complex<double>;

/// b −= factor · a
void subtract(Complex* b, const Complex* a, const Complex& factor, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i) b[i] -= product(factor, a[i]);
}

/// A⁻¹ B in place of B by Gaussian elimination with partial pivoting; A is spoilt.
void eliminate(MatrixXcd& a, MatrixXcd& b) {
  const Eigen::Index n = a.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      if (std::norm(a(i, k)) > std::norm(a(pivot, k))) pivot = i;
    }
    if (pivot != k) {
      a.row(k).swap(a.row(pivot));
      b.row(k).swap(b.row(pivot));
    }
    const Complex inverse = 1.0 / a(k, k);
    Complex* const factors = a.col(k).data() + k + 1;
    for (Eigen::Index i = 0; i < n - k - 1; ++i) factors[i] = product(factors[i], inverse);
    for (Eigen::Index j = k + 1; j < n; ++j) subtract(a.col(j).data() + k + 1, factors, a(k, j), n - k - 1);
    a(k, k) = inverse;
  }
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    Complex* const x = b.col(j).data();
    for (Eigen::Index k = 0; k < n; ++k) subtract(x + k + 1, a.col(k).data() + k + 1, x[k], n - k - 1);
    for (Eigen::Index k = n; k-- > 0;) {
      x[k] = product(x[k], a(k, k));
      subtract(x, a.col(k).data(), x[k], k);
    }
  }
}

MatrixXcd solve_few(const Eigen::Ref<const MatrixXcd>& a, const Eigen::Ref<const MatrixXcd>& b) {
  MatrixXcd factors = a, x = b;
  eliminate(factors, x);
  return x;
}

}  // namespace

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
  if (a.rows() <= few) return solve_few(a, b);
  return Eigen::PartialPivLU<MatrixXcd>(a).solve(b);
}

MatrixXcd inverse(const Eigen::Ref<const MatrixXcd>& a) {
  if (a.rows() <= few) return solve_few(a, MatrixXcd::Identity(a.rows(), a.cols()));
  return Eigen::PartialPivLU<MatrixXcd>(a).inverse();
}

Eigen::Matrix4d inverse_4x4(const Eigen::Matrix4d& a) { return a.inverse(); }

}  // namespace jointid::dense
