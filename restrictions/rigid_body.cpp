#include "restrictions/rigid_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/svd.hpp"

namespace jointid::restrictions {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Positions of the joint's nodes from their centroid.
struct Arms {
  std::map<std::int64_t, Vector3d> of_node;
  double rounding = 0.0;  ///< m; an arm is known no better
};

Arms arms_from_centroid(const std::vector<frf::Dof>& dofs,
                        const std::map<std::int64_t, std::array<double, 3>>& positions) {
  Arms arms;
  for (const frf::Dof& dof : dofs) arms.of_node[dof.node] = Vector3d(positions.at(dof.node).data());
  const auto count = static_cast<double>(arms.of_node.size());
  Vector3d centroid = Vector3d::Zero();
  for (const auto& [node, position] : arms.of_node) centroid += position / count;
  arms.rounding = 4 * count * eps * centroid.stableNorm();
  for (auto& [node, arm] : arms.of_node) {
    arm -= centroid;
    if (arm.stableNorm() <= arms.rounding) arm.setZero();  // a distance that only rounding makes is none
  }
  return arms;
}

double characteristic_length(const Arms& arms) {
  Eigen::VectorXd distances(at(arms.of_node.size()));
  Index i = 0;
  for (const auto& [node, arm] : arms.of_node) distances(i++) = arm.stableNorm();
  const double length = distances.stableNorm() / std::sqrt(static_cast<double>(distances.size()));
  return length > 0.0 ? length : 1.0;
}

Vector3d axis(frf::Direction direction) {
  const Index code = static_cast<Index>(direction) - 1;
  return Vector3d::Unit(code % 3);
}

/// V R, [DOFs, 6]: translations t, then ℓθ.
MatrixXd scaled_rigid_motions(const std::vector<frf::Dof>& dofs, const Arms& arms, double length) {
  MatrixXd motions = MatrixXd::Zero(at(dofs.size()), 6);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const Vector3d along = dofs[i].sign * axis(dofs[i].direction);
    const Index row = at(i);
    if (dofs[i].is_rotation()) {
      motions.row(row).tail<3>() = along.transpose();
    } else {
      motions.row(row).head<3>() = along.transpose();
      // along·(θ × arm) = (arm × along)·θ
      motions.row(row).tail<3>() = (arms.of_node.at(dofs[i].node) / length).cross(along).transpose();
    }
  }
  return motions;
}

/// Orthonormal basis of the complement of the columns' span; elements are in error by up to `rounding`.
MatrixXd complement(const MatrixXd& columns, double rounding) {
  const dense::RealSvd svd = dense::jacobi_svd(columns, dense::Vectors::full, dense::Vectors::none);
  const Eigen::VectorXd& sigma = svd.sigma;
  const auto rows = static_cast<double>(columns.rows());
  const double tolerance = eps * std::max(rows, 6.0) * sigma(0) + std::sqrt(rows) * rounding;
  const Index rank = (sigma.array() > tolerance).count();
  return svd.u.rightCols(columns.rows() - rank);
}

}  // namespace

Deformation deformation(const std::vector<frf::Dof>& dofs,
                        const std::map<std::int64_t, std::array<double, 3>>& positions) {
  const Arms arms = arms_from_centroid(dofs, positions);
  const double length = characteristic_length(arms);
  Deformation result;
  result.scale = Eigen::VectorXd::Ones(at(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (dofs[i].is_rotation()) result.scale(at(i)) = length;
  }
  result.basis = complement(scaled_rigid_motions(dofs, arms, length), arms.rounding / length);
  return result;
}

}  // namespace jointid::restrictions
