#pragma once

#include <Eigen/Core>

#include "restrictions/joint_spec.hpp"

namespace jointid::restrictions {

/// The motions of a joint's DOFs in which it deforms, in scaled coordinates.
///
/// A rigid body moves point r by t + θ×(r − c), c the centroid of the joint's nodes, and turns it by θ. Rotations at
/// DOFs are multiplied by the characteristic length ℓ (root mean square distance of the nodes from c; 1 m when all
/// nodes coincide), V = diag(1 or ℓ, in m per unit of the DOF), so that every coordinate is a length. The columns of
/// V R are the six rigid motions t and ℓθ; N is an orthonormal basis of the complement of their span. Its rank is the
/// number of singular values σ > eps·(max(DOFs, 6)·σ₁ + 4·√DOFs·nodes·|c|/ℓ): the second term is the rounding of
/// positions far from the origin. A DOF with a minus sign has the sign of its row flipped.
struct Deformation {
  Eigen::VectorXd scale;  ///< diagonal of V, [DOFs]
  Eigen::MatrixXd basis;  ///< N, [DOFs, m], Nᵀ V R = 0, NᵀN = I
};

/// Needs a finite position of every node of `dofs` in `positions` (m).
Deformation deformation(const std::vector<frf::Dof>& dofs,
                        const std::map<std::int64_t, std::array<double, 3>>& positions);

}  // namespace jointid::restrictions
