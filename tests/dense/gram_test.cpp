// AᵀA and AᵀB against Eigen's products, of every remainder of rows and columns.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "dense/gram.hpp"

namespace jointid::dense {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd numbers(Index rows, Index columns) {
  MatrixXd out(rows, columns);
  for (Index i = 0; i < out.size(); ++i) out.data()[i] = std::sin(1.7 * double(i * i % 977) + double(i));
  return out;
}

TEST(Gram, IsEigensProduct) {
  for (const Index rows : {0, 1, 3, 8, 13, 511, 512, 520, 1601}) {
    for (const Index columns : {1, 2, 3, 4, 5, 7, 10}) {
      const MatrixXd a = numbers(rows, columns), start = numbers(columns, columns), expected = start + a.transpose() * a;
      MatrixXd c = start;
      add_gram(a.data(), std::size_t(rows), std::size_t(columns), std::size_t(rows), c.data());
      for (Index j = 0; j < columns; ++j) {
        for (Index i = j; i < columns; ++i) EXPECT_NEAR(c(i, j), expected(i, j), 1e-12 * (1.0 + double(rows))) << rows << " × " << columns;
      }
    }
  }
}

TEST(Gram, CrossIsEigensProduct) {
  for (const Index rows : {0, 1, 7, 16, 513, 1030}) {
    for (const Index left : {1, 2, 4, 6, 9}) {
      for (const Index right : {1, 2, 3, 8}) {
        const MatrixXd a = numbers(rows, left), b = numbers(rows, right), start = numbers(left, right);
        MatrixXd c = start;
        add_cross(a.data(), std::size_t(left), b.data(), std::size_t(right), std::size_t(rows), c.data());
        EXPECT_LT((c - start - a.transpose() * b).cwiseAbs().maxCoeff(), 1e-12 * (1.0 + double(rows))) << rows << ": " << left << " × " << right;
      }
    }
  }
}

}  // namespace
}  // namespace jointid::dense
