#include "ident/variance/local_model.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/pivoted_qr.hpp"

namespace jointid::ident {
namespace {

/// Chebyshev polynomials 0 … order at places in [−1, 1].
Eigen::MatrixXd chebyshev(const Eigen::VectorXd& x, Eigen::Index order) {
  Eigen::MatrixXd t(x.size(), order + 1);
  t.col(0).setOnes();
  if (order > 0) t.col(1) = x;
  for (Eigen::Index i = 2; i <= order; ++i) t.col(i) = 2.0 * x.cwiseProduct(t.col(i - 1)) - t.col(i - 2);
  return t;
}

}  // namespace

SquaredError local_residual(std::span<const double> frequency_hz, std::span<const Complex> frf, std::size_t order) {
  const auto lines = at(frf.size()), size = static_cast<Eigen::Index>(order + 1);
  const double centre = 0.5 * (frequency_hz.front() + frequency_hz.back());
  const double half_width = 0.5 * (frequency_hz.back() - frequency_hz.front());
  Eigen::VectorXd x(lines);
  for (Eigen::Index i = 0; i < lines; ++i) x[i] = (frequency_hz[static_cast<std::size_t>(i)] - centre) / half_width;
  const Eigen::Map<const Eigen::VectorXcd> values(frf.data(), lines);
  const Eigen::MatrixXd basis = chebyshev(x, size - 1);
  const Eigen::MatrixXcd products = values.asDiagonal() * basis.cast<Complex>();
  // Unknowns: B and the lower coefficients of A; A's highest is 1, so that its roots may lie anywhere near.
  Eigen::MatrixXcd columns(lines, 2 * size - 1);
  columns << basis.cast<Complex>(), products.leftCols(size - 1);
  const dense::ComplexPivotedQr qr(columns);
  const Eigen::VectorXcd solution = qr.solve(products.col(size - 1));
  const Eigen::VectorXcd residual = products.col(size - 1) - columns * solution;
  const Eigen::VectorXcd denominator = basis.col(size - 1) - basis.leftCols(size - 1).cast<Complex>() * solution.tail(size - 1);
  const Eigen::MatrixXcd q = qr.orthonormal_columns(qr.rank());
  SquaredError out{.square = residual.squaredNorm(), .proportional = 0.0, .constant = 0.0, .freedom = 0.0};
  for (Eigen::Index i = 0; i < lines; ++i) {
    const double kept = std::max(0.0, 1.0 - q.row(i).squaredNorm()) * std::norm(denominator[i]);
    out.proportional += kept * std::norm(values[i]);
    out.constant += kept;
  }
  out.freedom = static_cast<double>(lines - qr.rank());
  return out;
}

}  // namespace jointid::ident
