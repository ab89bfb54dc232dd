#include "ident/likelihood/observed_information.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An information matrix, and a root of it: unknowns of different sizes.
struct Sample {
  std::mt19937_64 random;
  Eigen::Index size;
  MatrixXd root, information;

  explicit Sample(unsigned seed) : random(seed), size(std::uniform_int_distribution<Eigen::Index>(1, 6)(random)) {
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
    const MatrixXd basis = Eigen::SelfAdjointEigenSolver<MatrixXd>(any() + any().transpose()).eigenvectors();
    VectorXd values(size);
    for (double& value : values) value = std::uniform_real_distribution<double>(low, high)(random);
    return root.transpose() * basis * values.asDiagonal() * basis.transpose() * root;
  }
};

RC_GTEST_PROP(ObservedInformation, IsTheCurvatureOfAQuadraticFunction, (unsigned seed)) {
  Sample sample(seed);
  const MatrixXd curvature = sample.curvature(0.3, 0.9);
  const MatrixXd observed = observed_information([&](const VectorXd& offset) { return VectorXd(-curvature * offset); }, sample.information);
  RC_ASSERT((observed - curvature).norm() <= 1e-6 * curvature.norm());
}

RC_GTEST_PROP(ObservedInformation, CostsSixGradientsWhereItIsTheInformation, (unsigned seed)) {
  Sample sample(seed);
  int gradients = 0;
  const auto gradient = [&](const VectorXd& offset) {
    ++gradients;
    return VectorXd(-sample.information * offset);
  };
  RC_ASSERT(observed_information(gradient, sample.information) == sample.information);
  RC_ASSERT(gradients == 6);
}

RC_GTEST_PROP(ObservedInformation, IsTheInformationWhereDifferencesTellNoCurvature, (unsigned seed)) {
  Sample sample(seed);
  for (const double share : {-1.0, 5.0}) {
    const auto gradient = [&](const VectorXd& offset) { return VectorXd(-share * (sample.information * offset)); };
    RC_ASSERT(observed_information(gradient, sample.information) == sample.information);
  }
}

TEST(ObservedInformation, IsTheInformationWhereThatSaysNothingOfAnUnknown) {
  const MatrixXd information = Eigen::Vector2d(1.0, 0.0).asDiagonal();
  const auto gradient = [&](const VectorXd& offset) { return VectorXd(-0.5 * (information * offset)); };
  EXPECT_EQ(observed_information(gradient, information), information);
}

}  // namespace
}  // namespace jointid::ident
