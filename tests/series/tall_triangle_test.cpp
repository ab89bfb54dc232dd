#include "series/pod/tall_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dense/qr.hpp"
#include "dense/svd.hpp"

namespace jointid::series {
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

/// The triangle is Eigen's up to the signs of its rows.
TEST(TallTriangle, IsTheOneOfPlainReflections) {
  unsigned seed = 0;
  for (const auto& [rows, columns] :
       {std::pair<Index, Index>{1, 1}, {5, 1}, {7, 7}, {40, 15}, {40, 16}, {40, 17}, {300, 65}, {65, 65}, {90, 33}}) {
    const MatrixXd a = random_matrix(rows, columns, ++seed);
    MatrixXd work = a;
    const MatrixXd found = tall_triangle(work), plain = dense::triangle_of(a);
    for (Index i = 0; i < columns; ++i) {
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
  MatrixXd work = a;
  const MatrixXd r = tall_triangle(work);
  const Eigen::VectorXd size = a.colwise().norm().transpose().cwiseMax(1e-300);
  const MatrixXd off = (r.transpose() * r - a.transpose() * a).cwiseAbs();
  EXPECT_LT((size.cwiseInverse().asDiagonal() * off * size.cwiseInverse().asDiagonal()).maxCoeff(), 1e-12);
  const Eigen::VectorXd exact = dense::jacobi_svd(a, dense::Vectors::none, dense::Vectors::none).sigma;
  const Eigen::VectorXd found = dense::jacobi_svd(r, dense::Vectors::none, dense::Vectors::none).sigma;
  EXPECT_LT((found - exact).cwiseAbs().maxCoeff(), 1e-13 * exact(0));
  MatrixXd none = MatrixXd::Zero(20, 18);
  EXPECT_EQ(tall_triangle(none).cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace jointid::series
