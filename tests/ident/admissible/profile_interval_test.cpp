#include "ident/admissible/profile_interval.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "ident/admissible/admissible_fit.hpp"
#include "ident/admissible/sparse_semidefinite.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Inequality at_least(Index unknown, double limit) {
  return {"", "", "", SymmetricBlock{MatrixXd::Constant(1, 1, -limit), {unknown}, {{{0, 0, 1.0}}}}};
}

AdmissibleSet bounded_below(double limit, Index unknowns) {
  AdmissibleSet set;
  set.inequalities = {at_least(0, limit)};
  set.inside = VectorXd::Constant(unknowns, limit + 1.0);
  return set;
}

/// {t ≥ 0 | (t − x)² − min ≤ 3.84}
TEST(ProfileInterval, OfOneUnknownItIsTheClosedForm) {
  const AdmissibleSet set = bounded_below(0.0, 1);
  for (const double x : {-6.0, -1.0, 0.0, 0.5, 3.0}) {
    const auto found = profile_intervals(set, VectorXd::Constant(1, x), MatrixXd::Identity(1, 1))[0];
    const double least = std::pow(std::min(x, 0.0), 2), reach = std::sqrt(3.841458820694124 + least);
    EXPECT_NEAR(found[0], std::max(0.0, x - reach), 2e-3) << x;
    EXPECT_NEAR(found[1], x + reach, 2e-3) << x;
  }
}

/// Unit variances, correlation 0.9; the first is bounded by 0. Truth on the bound, and one standard deviation inside.
TEST(ProfileInterval, CoversTheTruthAtABoundAndBesideIt) {
  MatrixXd covariance(2, 2);
  covariance << 1.0, 0.9, 0.9, 1.0;
  MatrixXd lower(2, 2);
  lower << 1.0, 0.0, 0.9, std::sqrt(1.0 - 0.81);
  const MatrixXd root = lower.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(2, 2));
  constexpr int seeds = 400;
  for (const double truth : {0.0, 1.0}) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    int bounded = 0, neighbour = 0;
    double width = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
      VectorXd errors(2);
      for (double& each : errors) each = normal(random);
      const VectorXd estimate = VectorXd::Constant(2, truth) + lower * errors;
      const auto found = profile_intervals(bounded_below(0.0, 2), estimate, root);
      bounded += found[0][0] <= truth && truth <= found[0][1];
      neighbour += found[1][0] <= truth && truth <= found[1][1];
      width += (found[1][1] - found[1][0]) / seeds;
    }
    EXPECT_GE(bounded, 0.93 * seeds) << truth;
    EXPECT_LE(bounded, 0.985 * seeds) << truth;
    EXPECT_GE(neighbour, 0.93 * seeds) << truth;
    EXPECT_LE(neighbour, 0.98 * seeds) << truth;
    EXPECT_LT(width, 2.0 * 1.96) << truth;  // of its neighbour the bound takes uncertainty away
  }
}

TEST(ProfileInterval, TheDensestHoldsTheBoundAndNineteenTwentieths) {
  for (const double x : {-2.0, 0.0, 0.7, 4.0}) {
    const auto [low, high] = densest_interval(x, 1.0, 0.0, 1e9);
    const auto below = [&](double t) { return 0.5 * std::erfc((x - t) / std::sqrt(2.0)); };
    EXPECT_NEAR((below(high) - below(low)) / (1.0 - below(0.0)), 0.95, 1e-9) << x;
    EXPECT_EQ(low == 0.0, x < 1.5) << x;
  }
}

/// Problems made from their answer: K_e of known rank, Λ_e of the complementary one, and the estimate that they belong to.
TEST(SparseSemidefinite, FindsTheActiveSetOfTwoHundredSeeds) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr Index joints = 8, n = 3 * joints;
  for (int seed = 0; seed < 200; ++seed) {
    MatrixXd rows = MatrixXd::Zero(4 * n, n);
    for (Index row = 0; row < rows.rows(); ++row) {
      const Index joint = row % (joints - 1);
      for (Index u = 3 * joint; u < 3 * joint + 6; ++u) rows(row, u) = normal(random);
    }
    const MatrixXd information = rows.transpose() * rows;
    VectorXd answer(n), pull = VectorXd::Zero(n);
    std::vector<SymmetricBlock> blocks;
    std::vector<Index> zeros;
    for (Index joint = 0; joint < joints; ++joint) {
      const double angle = normal(random), a = 0.2 + std::abs(normal(random)), b = 0.2 + std::abs(normal(random));
      const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), across(-along[1], along[0]);
      const auto kind = static_cast<Index>(random() % 3);  // zero eigenvalues
      const Eigen::Matrix2d across_square = across * across.transpose(), along_square = along * along.transpose();
      Eigen::Matrix2d x = Eigen::Matrix2d::Zero(), multiplier = Eigen::Matrix2d::Zero();
      (kind < 2 ? x : multiplier) += a * along_square;
      (kind < 1 ? x : multiplier) += b * across_square;
      answer.segment(3 * joint, 3) << x(0, 0), x(0, 1), x(1, 1);
      blocks.push_back({MatrixXd::Zero(2, 2),
                        {3 * joint, 3 * joint + 1, 3 * joint + 2},
                        {{{0, 0, 1.0}}, {{0, 1, 1.0}, {1, 0, 1.0}}, {{1, 1, 1.0}}}});
      blocks.back().add_adjoint(10.0 * multiplier, pull);
      zeros.push_back(kind);
    }
    const VectorXd estimate = answer - information.ldlt().solve(pull);
    const auto fit = solve_sparse_semidefinite(blocks, estimate, information.sparseView(), 1.0);
    ASSERT_TRUE(fit && fit->converged) << seed;
    EXPECT_LT((fit->x - answer).cwiseAbs().maxCoeff(), 1e-5) << seed;
    EXPECT_EQ(fit->at_limit, zeros) << seed;
  }
}

/// The sparse way and the dense one.
TEST(SparseSemidefinite, AgreesWithTheDenseWay) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const MatrixXd root = MatrixXd::NullaryExpr(30, 12, [&] { return normal(random); });
  AdmissibleSet set;
  VectorXd estimate(12);
  for (double& each : estimate) each = normal(random);
  for (Index u = 0; u < 12; ++u) set.inequalities.push_back(at_least(u, u % 2 == 0 ? 0.0 : -0.5));
  set.inside = VectorXd::Ones(12);
  const AdmissibleFit dense = nearest_admissible(set, estimate, root, 1.0);
  const MatrixXd information = root.transpose() * root;
  const auto sparse = nearest_admissible(set, estimate, Eigen::SparseMatrix<double>(information.sparseView()), 1.0);
  ASSERT_TRUE(sparse);
  EXPECT_LT((dense.theta - sparse->theta).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_NEAR(dense.cost, sparse->cost, 1e-6 * dense.cost);
  EXPECT_EQ(dense.at_limit, sparse->at_limit);
}

}  // namespace
}  // namespace jointid::ident
