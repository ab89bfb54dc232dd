#include "problems/structure/frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "dense/cholesky.hpp"

namespace jointid::problems {
namespace {

using Eigen::Vector3d;

constexpr BarSection section = {.diameter = 0.03, .youngs_modulus = 2.0e11, .poissons_ratio = 0.25, .density = 7800.0};
const Vector3d skew(0.2, -0.3, 0.6);

Eigen::MatrixXd skew_stiffness() {
  const Matrix rows = frame_stiffness(section, {skew[0], skew[1], skew[2]});
  Eigen::MatrixXd k(12, 12);
  for (Eigen::Index i = 0; i < 12; ++i) {
    for (Eigen::Index j = 0; j < 12; ++j) k(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return k;
}

TEST(Frame, RigidMotionsMeetNoForce) {
  const Eigen::MatrixXd k = skew_stiffness();
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(12, 6);
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = Vector3d::Unit(i);
    rigid.block<3, 1>(0, i) = rigid.block<3, 1>(6, i) = axis;
    rigid.block<3, 1>(3, 3 + i) = rigid.block<3, 1>(9, 3 + i) = axis;
    rigid.block<3, 1>(6, 3 + i) = axis.cross(skew);
  }
  EXPECT_LT((k * rigid).norm(), 1e-12 * k.norm());
  EXPECT_EQ((k - k.transpose()).norm(), 0.0);
}

/// Of a clamped bar, the compliances of its end in the textbook: L³/3EI and L²/2EI across, L/EA along, L/GJ in torsion.
TEST(Frame, EndOfAClampedBar) {
  const Eigen::MatrixXd k = skew_stiffness();
  const double length = skew.norm(), inertia = std::numbers::pi * std::pow(section.diameter, 4) / 64.0;
  const double ei = section.youngs_modulus * inertia, gj = section.youngs_modulus / 2.5 * 2.0 * inertia;
  const Vector3d along = skew / length, across = along.unitOrthogonal();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(6);
  load.head<3>() = across;
  Eigen::VectorXd end = dense::solve_positive(k.bottomRightCorner(6, 6), load);
  EXPECT_LT((end.head<3>() - across * std::pow(length, 3) / (3.0 * ei)).norm(), 1e-9 * end.norm());
  EXPECT_LT((end.tail<3>() - along.cross(across) * length * length / (2.0 * ei)).norm(), 1e-9 * end.norm());
  load << along, along;
  end = dense::solve_positive(k.bottomRightCorner(6, 6), load);
  const double area = std::numbers::pi * std::pow(section.diameter, 2) / 4.0;
  EXPECT_LT((end.head<3>() - along * length / (section.youngs_modulus * area)).norm(), 1e-9 * end.norm());
  EXPECT_LT((end.tail<3>() - along * length / gj).norm(), 1e-9 * end.norm());
}

}  // namespace
}  // namespace jointid::problems
