#include "ident/likelihood/fit/godambe_information.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An information matrix, and a root of it: unknowns of different sizes.
struct RandomInformation {
  std::mt19937_64 random;
  Eigen::Index size;
  MatrixXd root, information;

  explicit RandomInformation(unsigned seed) : random(seed), size(std::uniform_int_distribution<Eigen::Index>(1, 6)(random)) {
    root = any() + 3.0 * MatrixXd::Identity(size, size);
    for (Eigen::Index c = 0; c < size; ++c) root.col(c) *= std::pow(10.0, std::uniform_real_distribution<double>(-3.0, 3.0)(random));
    information = root.transpose() * root;
  }

  MatrixXd any() {
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
  }

  /// With curvatures between `low` and `high` of the information's.
  MatrixXd curvature(double low, double high) {
    const MatrixXd basis = dense::symmetric_eigen(any() + any().transpose()).vectors;
    VectorXd values(size);
    for (double& value : values) value = std::uniform_real_distribution<double>(low, high)(random);
    return root.transpose() * basis * values.asDiagonal() * basis.transpose() * root;
  }
};

RC_GTEST_PROP(GodambeInformation, IsThatOfAQuadraticFunction, (unsigned seed)) {
  RandomInformation sample(seed);
  const MatrixXd curvature = sample.curvature(0.3, 0.9);
  const auto gradient = [&](const VectorXd& offset) { return VectorXd(-curvature * offset); };
  const MatrixXd found = godambe_information(one_by_one(gradient), sample.information);
  const MatrixXd expected = curvature * dense::solve_positive(sample.information, curvature);
  RC_ASSERT((found - expected).norm() <= 1e-6 * expected.norm());
}

/// A straight line through points with errors in both coordinates, y = θx: the estimate that has closed form (Deming), and its
/// variance (θ²+1)σ²/Σx² · (1 + σ²/((θ²+1)·mean x²)) for many points, against the scatter of estimates.
TEST(GodambeInformation, GivesTheVarianceOfALineThroughPointsWithErrorsInBothCoordinates) {
  constexpr int points = 200, trials = 4000;
  constexpr double slope = 0.7, sigma = 0.8;
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, sigma);
  double squares = 0.0, predicted = 0.0, promised = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    VectorXd x(points), y(points);
    for (int i = 0; i < points; ++i) {
      const double true_x = std::sin(i);
      x[i] = true_x + noise(random);
      y[i] = slope * true_x + noise(random);
    }
    // χ²(θ) = Σ(y − θx)²/((1 + θ²)σ²), each point's own x minimised out.
    const double xx = x.squaredNorm(), yy = y.squaredNorm(), xy = x.dot(y);
    const double estimate = ((yy - xx) + std::sqrt((yy - xx) * (yy - xx) + 4.0 * xy * xy)) / (2.0 * xy);
    const auto gradient = [&](const VectorXd& offset) {
      const double t = estimate + offset[0], q = 1.0 + t * t;
      return VectorXd::Constant(1, ((xy - t * xx) / q + t * (yy - 2.0 * t * xy + t * t * xx) / (q * q)) / (sigma * sigma)).eval();
    };
    const VectorXd fitted = (x + estimate * y) / (1.0 + estimate * estimate);
    const MatrixXd information = MatrixXd::Constant(1, 1, fitted.squaredNorm() / ((1.0 + estimate * estimate) * sigma * sigma));
    squares += (estimate - slope) * (estimate - slope);
    predicted += 1.0 / godambe_information(one_by_one(gradient), information)(0, 0);
    promised += 1.0 / information(0, 0);
  }
  EXPECT_NEAR(predicted / squares, 1.0, 0.15);
  EXPECT_LT(promised / squares, 0.7);
}

RC_GTEST_PROP(GodambeInformation, CostsSixGradientsWhereItIsTheInformation, (unsigned seed)) {
  RandomInformation sample(seed);
  int gradients = 0;
  const auto gradient = [&](const VectorXd& offset) {
    ++gradients;
    return VectorXd(-sample.information * offset);
  };
  RC_ASSERT(godambe_information(one_by_one(gradient), sample.information) == sample.information);
  RC_ASSERT(gradients == 6);
}

RC_GTEST_PROP(GodambeInformation, IsTheInformationWhereDifferencesTellNoCurvature, (unsigned seed)) {
  RandomInformation sample(seed);
  for (const double share : {-1.0, 5.0}) {
    const auto gradient = [&](const VectorXd& offset) { return VectorXd(-share * (sample.information * offset)); };
    RC_ASSERT(godambe_information(one_by_one(gradient), sample.information) == sample.information);
  }
}

TEST(GodambeInformation, IsTheInformationWhereThatSaysNothingOfAnUnknown) {
  const MatrixXd information = Eigen::Vector2d(1.0, 0.0).asDiagonal();
  const auto gradient = [&](const VectorXd& offset) { return VectorXd(-0.5 * (information * offset)); };
  EXPECT_EQ(godambe_information(one_by_one(gradient), information), information);
}

}  // namespace
}  // namespace jointid::ident
