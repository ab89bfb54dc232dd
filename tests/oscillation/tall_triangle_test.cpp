#include "oscillation/pod/tall_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dense/qr.hpp"
#include "dense/svd.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd out(rows, columns);
  for (double& x : out.reshaped()) x = normal(random);
  return out;
}

/// R of [o A]: the corner and the row behind it first.
MatrixXd triangle(const Eigen::VectorXd& ones, const MatrixXd& a) {
  TallTriangle rows(static_cast<std::size_t>(a.cols()));
  for (Index i = 0; i < a.rows(); ++i) {
    const Eigen::VectorXd row = a.row(i).transpose();
    EXPECT_TRUE(rows.push(ones(i), row.data()));
  }
  rows.flush();
  MatrixXd out = MatrixXd::Zero(a.cols() + 1, a.cols() + 1);
  out(0, 0) = rows.corner();
  for (Index j = 0; j < a.cols(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    out(0, 1 + j) = rows.top(column);
    for (Index i = 0; i <= j; ++i) out(1 + i, 1 + j) = rows(static_cast<std::size_t>(i), column);
  }
  return out;
}

MatrixXd triangle(const MatrixXd& a) { return triangle(Eigen::VectorXd::Zero(a.rows()), a).bottomRightCorner(a.cols(), a.cols()); }

/// The triangle is Eigen's up to the signs of its rows.
TEST(TallTriangle, IsTheOneOfPlainReflections) {
  unsigned seed = 0;
  for (const auto& [rows, columns] :
       {std::pair<Index, Index>{2, 1}, {5, 1}, {8, 7}, {40, 15}, {40, 16}, {40, 17}, {300, 64}, {1000, 65}, {66, 65}, {90, 33}}) {
    const MatrixXd a = random_matrix(rows, columns + 1, ++seed);
    const MatrixXd found = triangle(a.col(0), a.rightCols(columns)), plain = dense::triangle_of(a);
    for (Index i = 0; i <= columns; ++i) {
      const double sign = found(i, i) * plain(i, i) < 0.0 ? -1.0 : 1.0;
      EXPECT_LT((found.row(i) - sign * plain.row(i)).cwiseAbs().maxCoeff(), 1e-11 * a.norm())
          << rows << " " << columns << " " << i;
    }
  }
}

/// Columns that depend on each other, zeros, and columns of very different size: RᵀR = AᵀA column by column, small σ are kept.
TEST(TallTriangle, TakesPoorMatrices) {
  MatrixXd a = random_matrix(200, 40, 3);
  a.rightCols(10) = a.leftCols(10) + a.middleCols(10, 10);
  a.col(5).setZero();
  a.col(7) *= 1e-9;
  const MatrixXd r = triangle(a);
  const Eigen::VectorXd size = a.colwise().norm().transpose().cwiseMax(1e-300);
  const MatrixXd off = (r.transpose() * r - a.transpose() * a).cwiseAbs();
  EXPECT_LT((size.cwiseInverse().asDiagonal() * off * size.cwiseInverse().asDiagonal()).maxCoeff(), 1e-12);
  const Eigen::VectorXd exact = dense::jacobi_svd(a, dense::Vectors::none, dense::Vectors::none).sigma;
  const Eigen::VectorXd found = dense::jacobi_svd(r, dense::Vectors::none, dense::Vectors::none).sigma;
  EXPECT_LT((found - exact).cwiseAbs().maxCoeff(), 1e-13 * exact(0));
  EXPECT_EQ(triangle(MatrixXd::Zero(20, 18)).cwiseAbs().maxCoeff(), 0.0);
}

/// From the smallest numbers to the largest whose squares are numbers, the triangle only changes its size.
TEST(TallTriangle, HasNoUnit) {
  const MatrixXd a = random_matrix(300, 20, 9), r = triangle(a);
  for (const double unit : {1e-140, 1e-30, 1e30, 1e140})
    EXPECT_LT((triangle(unit * a) / unit - r).cwiseAbs().maxCoeff(), 1e-12 * a.norm()) << unit;
  EXPECT_TRUE(triangle(1e-200 * a).allFinite());
}

TEST(TallTriangle, LeavesRowsOutThatAreNotFinite) {
  TallTriangle rows(3);
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const double row[] = {1.0, 2.0, wrong};
    EXPECT_FALSE(rows.push(1.0, row));
  }
  rows.flush();
  EXPECT_EQ(rows.corner(), 0.0);
}

}  // namespace
}  // namespace jointid::oscillation
