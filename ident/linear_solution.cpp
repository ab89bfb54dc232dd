#include "ident/linear_solution.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "ident/column_scaling.hpp"
#include "ident/eigen_index.hpp"
#include "ident/null_space.hpp"
#include "ident/reduced_system.hpp"
#include "ident/rounding.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Above this many columns an SVD takes too long; the condition is then bounded from below by the pivots.
constexpr Index svd_limit = 300;

void judge(const MatrixXd& triangle, LinearSolution& out) {
  const Index n = triangle.cols(), rank = at(out.rank);
  const Eigen::BDCSVD<MatrixXd> svd(triangle, rank < n ? Eigen::ComputeFullV : 0);
  const VectorXd& sigma = svd.singularValues();
  out.condition = sigma[n - 1] > 0.0 ? sigma[0] / sigma[n - 1] : std::numeric_limits<double>::infinity();
  if (rank < n) tell_null_space(svd.matrixV().rightCols(n - rank), out);
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
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  const double threshold = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  qr.setThreshold(threshold);
  qr.compute(triangle);
  out.rank = static_cast<std::size_t>(qr.rank());
  VectorXd y;
  if (qr.rank() == n) {
    y = qr.solve(right);
  } else {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> minimum_norm;
    minimum_norm.setThreshold(threshold);
    minimum_norm.compute(triangle);
    y = minimum_norm.solve(right);
  }
  out.residual_norm = std::hypot((triangle * y - right).norm(), system(n, n));
  y = scale.asDiagonal() * y;
  out.y.assign(y.begin(), y.end());
  if (condition == Condition::skip && qr.rank() == n) return out;
  if (qr.rank() == n) {
    const VectorXd columns = triangle.colwise().stableNorm();
    const VectorXd rows = inverse_rows(qr.matrixR().topLeftCorner(n, n), qr.colsPermutation());
    bound_rounding({rows.cwiseProduct(scale), columns.cwiseQuotient(scale), std::hypot(right.norm(), system(n, n))},
                   Reduction::orthogonal, accumulator.rows_pushed(), out);
  }
  if (n <= svd_limit || qr.rank() < n) {
    judge(triangle, out);
  } else {
    out.condition = std::abs(qr.matrixQR()(0, 0) / qr.matrixQR()(n - 1, n - 1));
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
  const Eigen::LLT<MatrixXd> cholesky(scaled);
  LinearSolution out;
  const bool definite = cholesky.info() == Eigen::Success;
  VectorXd y = VectorXd::Zero(n);
  if (definite) y = scale.asDiagonal() * cholesky.solve(scale.asDiagonal() * product.col(n).head(n));
  out.rank = definite ? static_cast<std::size_t>(n) : 0;
  out.condition = definite ? 1.0 / std::sqrt(cholesky.rcond()) : std::numeric_limits<double>::infinity();
  out.y.assign(y.begin(), y.end());
  out.residual_norm = std::sqrt(std::max(0.0, product(n, n) - y.dot(product.col(n).head(n))));
  if (definite && condition == Condition::compute) {
    const VectorXd columns = product.diagonal().head(n).cwiseSqrt();
    const VectorXd rows = inverse_rows(MatrixXd(cholesky.matrixU()), MatrixXd::Identity(n, n));
    bound_rounding({rows.cwiseProduct(scale), columns, std::sqrt(product(n, n))}, Reduction::normal,
                   accumulator.rows_pushed(), out);
  }
  return out;
}

}  // namespace jointid::ident
