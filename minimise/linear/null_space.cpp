#include "minimise/linear/null_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "dense/qr.hpp"

namespace jointid::minimise {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Gauss–Jordan elimination of columns with full pivoting: each column gets a row where it is 1 and the others are 0.
MatrixXd separated(MatrixXd basis) {
  for (Index k = 0; k < basis.cols(); ++k) {
    Index row = 0, column = 0;
    basis.rightCols(basis.cols() - k).cwiseAbs().maxCoeff(&row, &column);
    basis.col(k).swap(basis.col(k + column));
    basis.col(k) /= basis(row, k);
    for (Index other = 0; other < basis.cols(); ++other) {
      if (other != k) basis.col(other) -= basis(row, other) * VectorXd(basis.col(k));
    }
  }
  return basis;
}

FreeDirection direction(const VectorXd& v) {
  FreeDirection free;
  std::vector<Index> order(static_cast<std::size_t>(v.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return std::abs(v[a]) > std::abs(v[b]); });
  for (const Index column : order) {
    if (std::abs(v[column]) >= 0.1 * std::abs(v[order[0]])) free.columns.push_back(static_cast<std::size_t>(column));
  }
  return free;
}

}  // namespace

void tell_null_space(const MatrixXd& basis, LinearSolution& out) {
  const MatrixXd unit = dense::orthonormal_columns(basis);
  const double tolerance = std::sqrt(std::numeric_limits<double>::epsilon());
  for (Index column = 0; column < unit.rows(); ++column) {
    if (unit.row(column).norm() > tolerance) out.undetermined.push_back(static_cast<std::size_t>(column));
  }
  const MatrixXd told = separated(unit);
  for (Index k = 0; k < told.cols(); ++k) out.free_directions.push_back(direction(told.col(k)));
}

VectorXd minimum_norm(const MatrixXd& basis, const VectorXd& y) {
  const MatrixXd unit = dense::orthonormal_columns(basis);
  return y - unit * (unit.transpose() * y);
}

}  // namespace jointid::minimise
