#include "problems/structure/frame.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace jointid::problems {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

/// Stiffness in axes along the bar.
Matrix12d local_stiffness(const BarSection& section, double length) {
  const double area = std::numbers::pi * std::pow(section.diameter, 2) / 4.0,
               inertia = std::numbers::pi * std::pow(section.diameter, 4) / 64.0;
  const double shear_modulus = section.youngs_modulus / (2.0 * (1.0 + section.poissons_ratio));
  const double bending = section.youngs_modulus * inertia / std::pow(length, 3);
  Matrix12d k = Matrix12d::Zero();
  const auto spring = [&](int i, double value) {
    k(i, i) += value;
    k(i + 6, i + 6) += value;
    k(i, i + 6) -= value;
    k(i + 6, i) -= value;
  };
  spring(0, section.youngs_modulus * area / length);
  spring(3, shear_modulus * 2.0 * inertia / length);
  // Over displacement and rotation at both ends; `turn` is −1 in the x-z plane, where a positive rotation lowers the bar.
  const auto bend = [&](int displacement, int rotation, double turn) {
    const std::array<int, 4> at = {displacement, rotation, displacement + 6, rotation + 6};
    const std::array<double, 4> sign = {1.0, turn, 1.0, turn};
    const double l = length;
    const double beam[4][4] = {{12, 6 * l, -12, 6 * l},
                               {6 * l, 4 * l * l, -6 * l, 2 * l * l},
                               {-12, -6 * l, 12, -6 * l},
                               {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) k(at[i], at[j]) += bending * sign[i] * sign[j] * beam[i][j];
    }
  };
  bend(1, 5, 1.0);
  bend(2, 4, -1.0);
  return k;
}

double length_of(const std::array<double, 3>& axis) { return std::hypot(axis[0], axis[1], axis[2]); }

std::array<double, 3> between(const frf::Node& from, const frf::Node& to) {
  return {to.position[0] - from.position[0], to.position[1] - from.position[1], to.position[2] - from.position[2]};
}

}  // namespace

Matrix frame_stiffness(const BarSection& section, const std::array<double, 3>& axis) {
  const Vector3d along = Vector3d(axis.data()).normalized();
  const Vector3d across = along.unitOrthogonal();
  Matrix3d axes;
  axes << along.transpose(), across.transpose(), along.cross(across).transpose();
  Matrix12d turn = Matrix12d::Zero();
  for (Eigen::Index block = 0; block < 4; ++block) turn.block<3, 3>(3 * block, 3 * block) = axes;
  const Matrix12d global = turn.transpose() * local_stiffness(section, length_of(axis)) * turn;
  Matrix out(12, std::vector<double>(12));
  for (Eigen::Index i = 0; i < 12; ++i) {
    for (Eigen::Index j = 0; j < 12; ++j)
      out[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = 0.5 * (global(i, j) + global(j, i));
  }
  return out;
}

std::vector<frf::Dof> frame_dofs(std::int64_t node) {
  std::vector<frf::Dof> dofs;
  for (int direction = 1; direction <= 6; ++direction)
    dofs.push_back({.node = node, .direction = static_cast<frf::Direction>(direction)});
  return dofs;
}

Structure frame(const BarSection& section, const std::vector<frf::Node>& nodes) {
  std::vector<frf::Dof> all;
  for (const frf::Node& node : nodes) {
    for (const frf::Dof& dof : frame_dofs(node.id)) all.push_back(dof);
  }
  Structure structure(nodes, all);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const std::array<double, 3> axis = between(nodes[i], nodes[i + 1]);
    std::vector<frf::Dof> ends = frame_dofs(nodes[i].id);
    for (const frf::Dof& dof : frame_dofs(nodes[i + 1].id)) ends.push_back(dof);
    structure.add(Kind::stiffness, ends, frame_stiffness(section, axis));
    const double half = 0.5 * section.density * std::numbers::pi * std::pow(section.diameter, 2) / 4.0 * length_of(axis);
    for (const frf::Dof& dof : ends) {
      structure.add(Kind::mass, {dof, {}}, dof.is_rotation() ? half * std::pow(section.diameter, 2) / 8.0 : half);
    }
  }
  return structure;
}

}  // namespace jointid::problems
