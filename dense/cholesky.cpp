#include "dense/cholesky.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace jointid::dense {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Ref;

std::optional<MatrixXd> cholesky(const Ref<const MatrixXd>& a) {
  const Eigen::LLT<MatrixXd> factors(a);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return MatrixXd(factors.matrixL());
}

bool cholesky_in_place(Ref<MatrixXd> a) { return Eigen::LLT<Ref<MatrixXd>>(a).info() == Eigen::Success; }

MatrixXcd semidefinite_cholesky(const Ref<const MatrixXcd>& a) {
  constexpr double rounding = 1e-12;
  const Eigen::Index n = a.rows();
  MatrixXcd l = MatrixXcd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double diagonal = a(k, k).real(), pivot = diagonal - l.row(k).head(k).squaredNorm();
    if (!(pivot > rounding * diagonal)) continue;
    const Eigen::Index below = n - k - 1;
    const double root = std::sqrt(pivot);
    l(k, k) = root;
    l.col(k).tail(below) = (a.col(k).tail(below) - l.bottomLeftCorner(below, k) * l.row(k).head(k).adjoint()) / root;
  }
  return l;
}

void solve_lower(const Ref<const MatrixXd>& l, Ref<MatrixXd> b) { l.triangularView<Eigen::Lower>().solveInPlace(b); }

void solve_lower_transposed(const Ref<const MatrixXd>& l, Ref<MatrixXd> b) {
  l.triangularView<Eigen::Lower>().transpose().solveInPlace(b);
}

MatrixXd solve_positive(const Ref<const MatrixXd>& a, const Ref<const MatrixXd>& b) { return Eigen::LLT<MatrixXd>(a).solve(b); }

MatrixXcd solve_positive(const Ref<const MatrixXcd>& a, const Ref<const MatrixXcd>& b) { return Eigen::LLT<MatrixXcd>(a).solve(b); }

std::optional<CholeskySolution> solve_definite(const Ref<const MatrixXd>& a, const Ref<const Eigen::VectorXd>& b) {
  const Eigen::LLT<MatrixXd> factors(a);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return CholeskySolution{factors.matrixL(), factors.solve(b), factors.rcond()};
}

MatrixXd solve_symmetric(const Ref<const MatrixXd>& a, const Ref<const MatrixXd>& b) { return Eigen::LDLT<MatrixXd>(a).solve(b); }

}  // namespace jointid::dense
