#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "dense/eigen.hpp"
#include "dense/real_lu.hpp"
#include "ident/admissible/definite_block.hpp"
#include "ident/admissible/semidefinite_least_squares.hpp"
#include "ident/admissible/tie.hpp"
#include "ident/admissible/tied_least_squares.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// X ⪰ 0 for a symmetric pattern: unknowns are the upper triangle row by row.
SymmetricBlock whole_matrix(Index size) {
  SymmetricBlock block{MatrixXd::Zero(size, size), {}, {}};
  for (Index i = 0; i < size; ++i) {
    for (Index j = i; j < size; ++j) {
      block.unknowns.push_back(static_cast<Index>(block.unknowns.size()));
      block.coefficients.push_back(i == j ? std::vector<BlockEntry>{{i, i, 1.0}}
                                          : std::vector<BlockEntry>{{i, j, 1.0}, {j, i, 1.0}});
    }
  }
  return block;
}

VectorXd upper(const MatrixXd& matrix) {
  VectorXd out(matrix.rows() * (matrix.rows() + 1) / 2);
  Index u = 0;
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = i; j < matrix.rows(); ++j) out[u++] = matrix(i, j);
  }
  return out;
}

MatrixXd inverse(const MatrixXd& a) { return dense::RealLu(a).solve(MatrixXd::Identity(a.rows(), a.cols())); }

/// Elements of the upper triangle count as often as they stand in the matrix: ‖D u‖ is the Frobenius norm.
MatrixXd frobenius(Index size) {
  const MatrixXd twice = MatrixXd::Constant(size, size, std::sqrt(2.0)) - (std::sqrt(2.0) - 1.0) * MatrixXd::Identity(size, size);
  return upper(twice).asDiagonal();
}

struct Sample {
  explicit Sample(unsigned seed, Index n) : random(seed), size(n) {
    const MatrixXd half = draw(n, (n + 1) / 2);
    const MatrixXd error = 0.2 * draw(n, n);
    matrix = half * half.transpose() + error + error.transpose();
    theta = upper(matrix);
    root =
        MatrixXd::Identity(theta.size(), theta.size()) + 0.5 / std::sqrt(double(theta.size())) * draw(theta.size(), theta.size());
  }

  MatrixXd draw(Index rows, Index columns) {
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
  }

  std::mt19937 random;
  Index size;
  MatrixXd matrix;
  VectorXd theta;
  MatrixXd root;  ///< of the metric
};

TEST(SemidefiniteLeastSquares, MeetsTheConditionsOfKarushKuhnAndTucker) {
  for (unsigned seed = 1; seed <= 120; ++seed) {
    const Sample sample(seed, 1 + seed % 6);
    const SymmetricBlock block = whole_matrix(sample.size);
    const MatrixXd basis = inverse(sample.root);
    const SemidefiniteFit fit = solve_semidefinite({block}, sample.theta, basis);
    ASSERT_TRUE(fit.converged) << seed;
    VectorXd force = VectorXd::Zero(sample.theta.size());
    block.add_adjoint(fit.multiplier[0], force);
    EXPECT_LT((basis.transpose() * force - fit.x).norm(), 1e-5 * std::max(1.0, fit.x.norm())) << seed;
    const MatrixXd value = block.at(sample.theta + basis * fit.x);
    EXPECT_GT(least_eigenvalue(value), -1e-12 * sample.theta.norm()) << seed;
    EXPECT_GE(least_eigenvalue(fit.multiplier[0]), -1e-12 * fit.multiplier[0].norm()) << seed;
    EXPECT_LT(value.cwiseProduct(fit.multiplier[0]).sum(), 1e-7 * std::max(1.0, fit.x.squaredNorm())) << seed;
  }
}

TEST(SemidefiniteLeastSquares, InTheFrobeniusNormNegativeEigenvaluesAreCutOff) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Sample sample(seed, 5);
    const SemidefiniteFit fit = solve_semidefinite({whole_matrix(5)}, sample.theta, inverse(frobenius(5)));
    const dense::SymmetricEigen eigen = dense::symmetric_eigen(sample.matrix);
    const MatrixXd cut = eigen.vectors * eigen.values.cwiseMax(0.0).asDiagonal() * eigen.vectors.transpose();
    EXPECT_LT((fit.value[0] - cut).norm(), 1e-5);
    EXPECT_EQ(fit.at_limit[0], (eigen.values.array() < 0.0).count());
  }
}

/// Alternating directions: min ½‖R(θ − θ̂)‖² + [Z ⪰ 0], X(θ) = Z.
VectorXd by_alternating_directions(const Sample& sample) {
  const MatrixXd metric = frobenius(sample.size);
  const double penalty = 3.0;
  const MatrixXd normal = sample.root.transpose() * sample.root, weight = penalty * metric * metric;
  const dense::RealLu system(normal + weight);
  VectorXd theta = sample.theta, z = theta, dual = VectorXd::Zero(theta.size());
  const SymmetricBlock block = whole_matrix(sample.size);
  for (int iteration = 0; iteration < 20000; ++iteration) {
    theta = system.solve(normal * sample.theta + weight * (z - dual));
    const dense::SymmetricEigen eigen = dense::symmetric_eigen(block.at(theta + dual));
    z = upper(eigen.vectors * eigen.values.cwiseMax(0.0).asDiagonal() * eigen.vectors.transpose());
    dual += theta - z;
  }
  return z;
}

TEST(SemidefiniteLeastSquares, AgreesWithAlternatingDirections) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Sample sample(seed, 4);
    const MatrixXd basis = inverse(sample.root);
    const SemidefiniteFit fit = solve_semidefinite({whole_matrix(4)}, sample.theta, basis);
    EXPECT_LT((sample.theta + basis * fit.x - by_alternating_directions(sample)).norm(), 1e-5 * sample.theta.norm());
  }
}

TEST(TiedLeastSquares, AgreesWithLagrangeMultipliers) {
  Sample sample(7, 3);
  const MatrixXd ties = sample.draw(2, 6);
  const VectorXd values = sample.draw(2, 1);
  const TiedUnknowns free = eliminate({{ties.row(0).transpose(), values[0]}, {ties.row(1).transpose(), values[1]}}, 6);
  const TiedLeastSquares tied = tied_least_squares(sample.root, sample.theta, free.offset, free.directions);
  MatrixXd bordered = MatrixXd::Zero(8, 8);
  bordered.topLeftCorner(6, 6) = sample.root.transpose() * sample.root;
  bordered.topRightCorner(6, 2) = ties.transpose();
  bordered.bottomLeftCorner(2, 6) = ties;
  VectorXd right(8);
  right << bordered.topLeftCorner(6, 6) * sample.theta, values;
  EXPECT_LT((tied.theta - dense::RealLu(bordered).solve(right).topRows(6)).norm(), 1e-10 * sample.theta.norm());
  EXPECT_LT((ties * tied.theta - values).norm(), 1e-10);
  // ‖R(θ + basis·x − θ̂)‖² is the least plus ‖x‖².
  const VectorXd x = sample.draw(4, 1);
  const double least = (sample.root * (tied.theta - sample.theta)).squaredNorm();
  EXPECT_NEAR((sample.root * (tied.theta + tied.basis * x - sample.theta)).squaredNorm(), least + x.squaredNorm(),
              1e-9 * (least + 1.0));
  EXPECT_EQ(tied.null_space.cols(), 0);
}

TEST(TiedLeastSquares, TellsWhatIsNotFixed) {
  Sample sample(8, 3);
  const VectorXd free = sample.draw(6, 1).normalized();
  const MatrixXd root = sample.root * (MatrixXd::Identity(6, 6) - free * free.transpose());
  const TiedLeastSquares found = tied_least_squares(root, sample.theta, {}, {});
  ASSERT_EQ(found.null_space.cols(), 1);
  EXPECT_NEAR(std::abs(found.null_space.col(0).normalized().dot(free)), 1.0, 1e-9);
}

TEST(Ties, AreReadWithTheNamesOfUnknowns) {
  const std::vector<std::string> names = {"K(1,1)", "K(1,2)", "left.K.a", "left.K.ab", "K[4:+Y,5:+Y]"};
  const Tie tie = parse_tie("K(1,1) = 2*left.K.a - left.K.ab/4 + 1e3", names);
  EXPECT_EQ(tie.coefficients, (VectorXd(5) << 1.0, 0.0, -2.0, 0.25, 0.0).finished());
  EXPECT_EQ(tie.value, 1e3);
  EXPECT_EQ(parse_tie("K[4:+Y,5:+Y] = K(1,2)", names).coefficients, (VectorXd(5) << 0.0, -1.0, 0.0, 0.0, 1.0).finished());
  for (const char* wrong :
       {"K(1,1)", "K(1,1) = K(2,2)", "K(1,1) = K(1,1)*K(1,2)", "1 = 2", "K(1,1) = K(1,1)", "K(1,1) = = 3", "left.K.abc = 1"}) {
    EXPECT_THROW(parse_tie(wrong, names), InputError) << wrong;
  }
}

TEST(Ties, EqualUnknownsBecomeOne) {
  const auto row = [](std::initializer_list<double> values) {
    return VectorXd(Eigen::Map<const VectorXd>(values.begin(), Index(values.size())));
  };
  // a = b, b = c, and the same again in other words.
  const TiedUnknowns free = eliminate({{row({1, -1, 0, 0}), 0.0}, {row({0, 1, -1, 0}), 0.0}, {row({2, 0, -2, 0}), 0.0}}, 4);
  ASSERT_EQ(free.directions.cols(), 2);
  const VectorXd theta = free.offset + free.directions * row({0.1, 7.0});
  EXPECT_EQ(theta[0], theta[1]);
  EXPECT_EQ(theta[1], theta[2]);
  EXPECT_THROW(eliminate({{row({1, -1}), 0.0}, {row({-1, 1}), 1.0}}, 2), InputError);
  EXPECT_THROW(eliminate({{row({1, -1}), 0.0}, {row({1, 1}), 1.0}}, 2), InputError);
}

TEST(DefiniteBlock, LeavesOutWhatThePatternMakesSingular) {
  // a at (1,1), −a at (1,2), a at (2,2): one spring, of rank 1.
  restrictions::MatrixTerms spring{
      restrictions::Kind::stiffness, {{0, 0, 0, 1.0}, {0, 1, 0, -1.0}, {1, 0, 0, -1.0}, {1, 1, 0, 1.0}}, {}};
  const auto block = definite_block(spring, 0, 2, {{0, 0}}, 1.0);
  ASSERT_TRUE(block);
  ASSERT_EQ(block->size(), 1);
  EXPECT_NEAR(block->at(VectorXd::Constant(1, 3.0))(0, 0), 6.0, 1e-12);
  spring.terms[1].coefficient = -2.0;
  EXPECT_FALSE(definite_block(spring, 0, 2, {{0, 0}}, 1.0));
}

}  // namespace
}  // namespace jointid::ident
