#include "ident/linear_solution.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/column_scaling.hpp"
#include "ident/null_space.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Above this many columns an SVD costs more than it tells; the condition is then estimated from the pivots.
constexpr Index svd_limit = 300;

Index index(std::size_t i) { return static_cast<Index>(i); }

/// All triangles one below the other, right-hand side last.
MatrixXd stack(const Accumulator& accumulator) {
  std::size_t rows = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) rows += columns.size() + 1;
  MatrixXd system = MatrixXd::Zero(index(rows), index(accumulator.columns() + 1));
  Index row = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    const std::size_t n = columns.size();
    for (std::size_t i = 0; i <= n; ++i, ++row) {
      for (std::size_t j = i; j < n; ++j) system(row, index(columns[j])) = triangle(i, j);
      system(row, index(accumulator.columns())) = triangle(i, n);
    }
  }
  return system;
}

void judge(const MatrixXd& triangle, const VectorXd& pivots, LinearSolution& out) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Index n = triangle.cols(), rank = index(out.rank);
  const auto ratio = [&](const VectorXd& falling) {  // fewer rows than columns have no last value
    return falling.size() == n && falling[n - 1] != 0.0 ? std::abs(falling[0] / falling[n - 1]) : infinity;
  };
  out.condition = ratio(pivots);
  if (n > svd_limit && rank == n) return;
  const Eigen::BDCSVD<MatrixXd> svd(triangle, rank < n ? Eigen::ComputeFullV : 0);
  out.condition = ratio(svd.singularValues());
  if (rank < n) tell_null_space(svd.matrixV().rightCols(n - rank), out);
}

}  // namespace

LinearSolution solve_dense(Accumulator& accumulator) {
  accumulator.flush();
  const Index n = index(accumulator.columns());
  MatrixXd system = stack(accumulator);
  const VectorXd scale = power_of_two_scales(system.leftCols(n));
  system.leftCols(n) *= scale.asDiagonal();
  if (accumulator.triangles().size() > 1) {
    const Eigen::HouseholderQR<MatrixXd> reduction(system);
    const Index kept = std::min(system.rows(), n + 1);
    system = MatrixXd(reduction.matrixQR().topRows(kept).triangularView<Eigen::Upper>());
  }
  const MatrixXd triangle = system.topLeftCorner(std::min(n, system.rows()), n);
  const VectorXd right = system.col(n).head(triangle.rows());
  LinearSolution out;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon());
  decomposition.compute(triangle);
  out.rank = static_cast<std::size_t>(decomposition.rank());
  const VectorXd y = scale.asDiagonal() * VectorXd(decomposition.solve(right));
  out.y.assign(y.begin(), y.end());
  out.residual_norm = (system.leftCols(n) * scale.cwiseInverse().asDiagonal() * y - system.col(n)).norm();
  judge(triangle, decomposition.matrixQTZ().diagonal(), out);
  return out;
}

LinearSolution solve_normal(Accumulator& accumulator) {
  accumulator.flush();
  const Index n = index(accumulator.columns());
  MatrixXd product = MatrixXd::Zero(n + 1, n + 1);
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    std::vector<std::size_t> place = columns;
    place.push_back(accumulator.columns());
    for (std::size_t i = 0; i < place.size(); ++i) {
      for (std::size_t j = i; j < place.size(); ++j) product(index(place[i]), index(place[j])) += triangle(i, j);
    }
  }
  product = MatrixXd(product.selfadjointView<Eigen::Upper>());
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
  return out;
}

}  // namespace jointid::ident
