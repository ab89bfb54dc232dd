#include "series/pod/tall_triangle.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::series {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index panel_columns = 16;

/// H = I − τvvᵀ that takes the column to its first entry; v, whose first entry is 1, replaces the others. Returns τ.
double reflect(Eigen::Ref<Eigen::VectorXd> column) {
  auto rest = column.tail(column.size() - 1);
  const double squares = rest.squaredNorm(), first = column(0);
  if (squares == 0.0) return 0.0;
  const double length = -std::copysign(std::sqrt(first * first + squares), first);
  rest /= first - length;
  column(0) = length;
  return (length - first) / length;
}

/// Reflects the columns of a panel one after another; returns T of I − VTVᵀ, their product.
MatrixXd reflect_panel(Eigen::Ref<MatrixXd> panel, MatrixXd& v) {
  const Index width = panel.cols();
  v = MatrixXd::Zero(panel.rows(), width);
  MatrixXd t = MatrixXd::Zero(width, width);
  for (Index j = 0; j < width; ++j) {
    const Index left = panel.rows() - j, behind = width - j - 1;
    const double tau = reflect(panel.col(j).tail(left));
    v(j, j) = 1.0;
    v.col(j).tail(left - 1) = panel.col(j).tail(left - 1);
    auto others = panel.bottomRightCorner(left, behind);
    const Eigen::RowVectorXd along = tau * (v.col(j).tail(left).transpose() * others);
    others.noalias() -= v.col(j).tail(left) * along;
    t(j, j) = tau;
    if (j > 0) {
      const Eigen::VectorXd before = v.leftCols(j).bottomRows(left).transpose() * v.col(j).tail(left);
      t.col(j).head(j) = t.topLeftCorner(j, j) * (-tau * before);
    }
  }
  return t;
}

}  // namespace

MatrixXd tall_triangle(MatrixXd& a) {
  const Index rows = a.rows(), columns = a.cols();
  MatrixXd v, product;
  for (Index first = 0; first < columns; first += panel_columns) {
    const Index width = std::min(panel_columns, columns - first), behind = columns - first - width;
    const MatrixXd t = reflect_panel(a.block(first, first, rows - first, width), v);
    if (behind == 0) break;
    auto others = a.bottomRightCorner(rows - first, behind);
    product.noalias() = v.transpose() * others;
    product = (t.transpose() * product).eval();
    others.noalias() -= v * product;
  }
  return a.topRows(columns).triangularView<Eigen::Upper>();
}

}  // namespace jointid::series
