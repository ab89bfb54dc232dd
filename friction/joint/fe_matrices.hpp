#pragma once

#include <Eigen/SparseCore>

#include "friction/joint/joint_mesh.hpp"

namespace jointid::friction {

/// Stiffness of the members and the end spring: one DOF for each node of a bar, displacement and rotation for a beam.
Eigen::SparseMatrix<double> member_matrix(const JointMesh& mesh);

/// Half of the lengths of the members at a node, but only of those with an interface at both ends.
double tributary_length(const JointMesh& mesh, std::size_t node);

}  // namespace jointid::friction
