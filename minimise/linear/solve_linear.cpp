#include "minimise/linear/solve_linear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/minimum_norm.hpp"
#include "dense/pivoted_qr.hpp"
#include "dense/svd.hpp"
#include "minimise/linear/column_scaling.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/reduced_system.hpp"
#include "minimise/linear/rounding.hpp"

namespace jointid::minimise {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Above this many columns an SVD takes too long; the condition is then bounded from below by the pivots.
constexpr Index svd_limit = 300;

void judge(const MatrixXd& triangle, LinearSolution& out) {
  const Index n = triangle.cols(), rank = at(out.rank);
  const dense::RealSvd svd = dense::svd(triangle, dense::Vectors::none, rank < n ? dense::Vectors::full : dense::Vectors::none);
  const VectorXd& sigma = svd.sigma;
  out.condition = sigma[n - 1] > 0.0 ? sigma[0] / sigma[n - 1] : std::numeric_limits<double>::infinity();
  if (rank < n) tell_null_space(svd.v.rightCols(n - rank), out);
}

/// Normal numbers of variance 1/columns: the norms of the rows of R⁻¹G are about those of R⁻¹.
MatrixXd random_columns(Index rows, Index columns) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0.0, 1.0 / std::sqrt(static_cast<double>(columns)));
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// ‖rows of R⁻¹‖ of an upper triangle whose columns stand in the order of `permutation`; of a large one estimated.
template <class Matrix, class Permutation>
VectorXd inverse_rows(const Matrix& r, const Permutation& permutation) {
  const Index n = r.rows();
  const MatrixXd right = n <= svd_limit ? MatrixXd(MatrixXd::Identity(n, n)) : random_columns(n, 16);
  const MatrixXd inverse = r.template triangularView<Eigen::Upper>().solve(right);
  return permutation * VectorXd(inverse.rowwise().norm());
}

}  // namespace

LinearSolution solve_dense(Accumulator& accumulator, Condition condition) {
  accumulator.flush();
  const Index n = at(accumulator.columns());
  MatrixXd system = reduced_system(accumulator);
  const VectorXd scale = power_of_two_scales(system.leftCols(n));
  system.leftCols(n) *= scale.asDiagonal();
  const MatrixXd triangle = system.topLeftCorner(n, n);
  const VectorXd right = system.col(n).head(n);
  LinearSolution out;
  const double threshold = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const dense::RealPivotedQr qr(triangle, threshold);
  out.rank = static_cast<std::size_t>(qr.rank());
  VectorXd y;
  if (qr.rank() == n) {
    y = qr.solve(right);
  } else {
    y = dense::RealMinimumNorm(triangle, threshold).solve(right);
  }
  out.residual_norm = std::hypot((triangle * y - right).norm(), system(n, n));
  y = scale.asDiagonal() * y;
  out.y.assign(y.begin(), y.end());
  if (condition == Condition::skip && qr.rank() == n) return out;
  if (qr.rank() == n) {
    const VectorXd columns = triangle.colwise().stableNorm();
    const VectorXd rows = inverse_rows(qr.triangle(), qr.permutation());
    bound_rounding({rows.cwiseProduct(scale), columns.cwiseQuotient(scale), std::hypot(right.norm(), system(n, n))},
                   Reduction::orthogonal, accumulator.rows_pushed(), out);
  }
  if (n <= svd_limit || qr.rank() < n) {
    judge(triangle, out);
  } else {
    const MatrixXd r = qr.triangle();
    out.condition = std::abs(r(0, 0) / r(n - 1, n - 1));
  }
  return out;
}

LinearSolution solve_normal(Accumulator& accumulator, Condition condition) {
  accumulator.flush();
  const Index n = at(accumulator.columns());
  const MatrixXd product = normal_product(accumulator);
  VectorXd scale(n);
  for (Index j = 0; j < n; ++j) scale[j] = power_of_two_scale(std::sqrt(product(j, j)));
  const MatrixXd scaled = scale.asDiagonal() * product.topLeftCorner(n, n) * scale.asDiagonal();
  const auto solved = dense::solve_definite(scaled, scale.asDiagonal() * product.col(n).head(n));
  LinearSolution out;
  const bool definite = solved.has_value();
  VectorXd y = VectorXd::Zero(n);
  if (definite) y = scale.asDiagonal() * solved->x;
  out.rank = definite ? static_cast<std::size_t>(n) : 0;
  out.condition = definite ? 1.0 / std::sqrt(solved->reciprocal_condition) : std::numeric_limits<double>::infinity();
  out.y.assign(y.begin(), y.end());
  out.residual_norm = std::sqrt(std::max(0.0, product(n, n) - y.dot(product.col(n).head(n))));
  if (definite && condition == Condition::compute) {
    const VectorXd columns = product.diagonal().head(n).cwiseSqrt();
    const VectorXd rows = inverse_rows(MatrixXd(solved->lower.transpose()), MatrixXd::Identity(n, n));
    bound_rounding({rows.cwiseProduct(scale), columns, std::sqrt(product(n, n))}, Reduction::normal, accumulator.rows_pushed(),
                   out);
  }
  return out;
}

}  // namespace jointid::minimise
