#include "dense/lu.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

namespace jointid::dense {
namespace {

Eigen::MatrixXcd any(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXcd::NullaryExpr(rows, columns, [&] { return std::complex<double>(normal(random), normal(random)); });
}

/// Small ones are eliminated without blocks, large ones with them.
RC_GTEST_PROP(ComplexLu, SolvesMatricesOfAllSizes, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const Eigen::Index n = std::uniform_int_distribution<Eigen::Index>(1, 16)(random), m = 5;
  const Eigen::MatrixXcd a = any(n, n, random), x = any(n, m, random), b = a * x;
  const double size = a.norm() * inverse(a).norm();
  RC_ASSERT((solve(a, b) - x).norm() <= 1e-13 * size * x.norm());
  RC_ASSERT((solve(a, b) - ComplexLu(a).solve(b)).norm() <= 1e-13 * size * x.norm());
  RC_ASSERT((inverse(a) * a - Eigen::MatrixXcd::Identity(n, n)).norm() <= 1e-13 * size * std::sqrt(double(n)));
}

TEST(ComplexLu, ExchangesRowsWherePivotsAreZero) {
  Eigen::MatrixXcd a = Eigen::MatrixXcd::Zero(4, 4);
  a(0, 2) = 2.0;
  a(1, 0) = {0.0, 1.0};
  a(2, 3) = -1.0;
  a(3, 1) = 4.0;
  const Eigen::MatrixXcd x = Eigen::MatrixXcd::Random(4, 2);
  EXPECT_LE((solve(a, a * x) - x).norm(), 1e-15);
}

TEST(ComplexLu, HasNoFiniteSolutionOfASingularMatrix) {
  for (const Eigen::Index n : {3, 12}) {
    Eigen::MatrixXcd a = Eigen::MatrixXcd::Identity(n, n);
    a(n - 1, n - 1) = 0.0;
    EXPECT_FALSE(solve(a, Eigen::MatrixXcd::Ones(n, 1)).allFinite()) << n;
    EXPECT_FALSE(inverse(a).allFinite()) << n;
  }
}

}  // namespace
}  // namespace jointid::dense
