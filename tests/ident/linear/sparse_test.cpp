#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "base/eigen.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/sparse_covariance.hpp"
#include "minimise/linear/sparse_normal.hpp"
#include "tests/require.hpp"

namespace jointid::minimise {
namespace {

/// A chain of supports of six columns, three of which are those of the next one.
Accumulator chain_system(std::size_t supports, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Accumulator system(3 * (supports + 1));
  for (std::size_t s = 0; s < supports; ++s) {
    Accumulator::Columns columns;
    for (std::size_t k = 0; k < 6; ++k) columns.push_back(3 * s + k);
    Triangle& triangle = system.triangle(columns);
    for (int row = 0; row < 10; ++row) {
      double* to = triangle.append(1);
      for (std::size_t k = 0; k <= 6; ++k) to[k] = normal(random) * std::pow(10.0, static_cast<double>(k % 3));
    }
  }
  system.flush();
  return system;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return difference / size;
}

TEST(SparseSolvers, AllGiveTheDenseSolutionAndItsNorms) {
  if (!has_spqr()) JOINTID_SKIP("SuiteSparse is not here");
  Accumulator system = chain_system(60, 1);
  const LinearSolution dense = solve_dense(system);
  testing::internal::CaptureStdout();
  for (const SparseWay way : {SparseWay::qr, SparseWay::cholmod, SparseWay::ldlt}) {
    const LinearSolution sparse = solve_sparse(system, Condition::compute, way);
    EXPECT_EQ(sparse.rank, 183u);
    EXPECT_LT(largest_difference(sparse.y, dense.y), 1e-13);
    EXPECT_LT(largest_difference(sparse.inverse_norms, dense.inverse_norms), 1e-10);
    EXPECT_NEAR(sparse.residual_norm / dense.residual_norm, 1.0, 1e-12);
    EXPECT_LE(sparse.condition, dense.condition * (1.0 + 1e-9));
    EXPECT_GE(sparse.condition, 0.7 * dense.condition);
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

/// A matrix that is not positive definite to rounding: CHOLMOD would print that.
TEST(SparseSolvers, NormalEquationsHandOverToQrAndPrintNothing) {
  if (!has_spqr()) JOINTID_SKIP("SuiteSparse is not here");
  Accumulator system(3);
  for (int row = 0; row < 3; ++row) {
    double* to = system.triangle({0, 1, 2}).append(1);
    to[0] = 1.0 + row;
    to[1] = 2.0 + row * row;
    to[2] = to[0] + to[1];
    to[3] = 1.0;
  }
  testing::internal::CaptureStdout();
  for (const SparseWay way : {SparseWay::qr, SparseWay::cholmod, SparseWay::ldlt}) {
    const LinearSolution found = solve_sparse(system, Condition::compute, way);
    EXPECT_EQ(found.rank, 2u);
    ASSERT_EQ(found.free_directions.size(), 1u);
    EXPECT_EQ(found.undetermined.size(), 3u);
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

/// Kahan (1966): unit columns, pivots of 6e-3 and more, smallest singular value 1e-15. SPQR alone says full rank.
TEST(SparseSolvers, KahansMatrixHasNoFullRank) {
  if (!has_spqr()) JOINTID_SKIP("SuiteSparse is not here");
  constexpr std::size_t n = 120;
  const double s = std::pow(6e-3, 1.0 / (n - 1)), c = std::sqrt(1.0 - s * s);
  Accumulator system(n);
  Accumulator::Columns columns;
  for (std::size_t j = 0; j < n; ++j) columns.push_back(j);
  for (std::size_t i = 0; i < n; ++i) {
    double* row = system.triangle(columns).append(1);
    const double scale = std::pow(s, static_cast<double>(i));
    row[i] = scale;
    for (std::size_t j = i + 1; j < n; ++j) row[j] = -c * scale;
    row[n] = 1.0;
  }
  const LinearSolution found = solve_sparse(system);
  EXPECT_EQ(found.rank, n - 1);
  EXPECT_EQ(found.free_directions.size(), 1u);
  EXPECT_TRUE(std::isinf(found.condition));
}

TEST(SparseCovarianceTest, IsTheDenseInverseWhereItIsWorkedOut) {
  const Accumulator system = chain_system(12, 2);
  const StackedTriangles stacked(system);
  const std::size_t n = stacked.matrix.columns;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(at(stacked.matrix.rows), at(n));
  for (std::size_t e = 0; e < stacked.matrix.value.size(); ++e) {
    a(stacked.matrix.row[e], stacked.matrix.column[e]) += stacked.matrix.value[e];
  }
  const Eigen::MatrixXd exact = (a.transpose() * a).inverse();
  const SparseCovariance found(stacked);
  const std::vector<double> variances = found.variances();
  ASSERT_EQ(variances.size(), n);
  std::size_t neighbours = 0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(variances[i] / exact(at(i), at(i)), 1.0, 1e-11);
    for (std::size_t j = 0; j < n; ++j) {
      if (std::isnan(found(i, j))) continue;
      EXPECT_NEAR(found(i, j), exact(at(i), at(j)), 1e-11 * exact.cwiseAbs().maxCoeff());
      ++neighbours;
    }
    if (i + 1 < n && i % 3 != 2) {
      EXPECT_FALSE(std::isnan(found(i, i + 1)));  // of one joint
    }
  }
  EXPECT_LT(neighbours, n * n / 2);
}

}  // namespace
}  // namespace jointid::minimise
