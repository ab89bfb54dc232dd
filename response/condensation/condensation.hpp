#pragma once

#include <Eigen/Core>

#include "response/time/force_history.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// A basis in which a structure moves, x = T y (Ren 1992, 3.52), columns M-orthonormal, and how many of what it has.
struct Basis {
  Eigen::MatrixXd columns;  ///< T, N × columns
  Eigen::Index modes = 0, attachments = 0;
};

/// The first `count` modes without joints, K φ = ω²M φ, whose relative motions span the slip. Throws InputError when there are
/// fewer.
Basis free_modes(const JointedStructure& structure, Eigen::Index count);

/// The first modes with the joints sticking, K + W k Wᵀ, k = `stiffness` by joint: they hold the slip back; kept for comparison.
Basis lock_modes(const JointedStructure& structure, Eigen::Index count, const Eigen::VectorXd& stiffness);

/// Free modes and the static deflections by the joints' forces, K⁻¹W (of free–free structures by inertia relief: without
/// rigid-body motion). Deflections that the others hold already are left out.
Basis free_and_attachment_modes(const JointedStructure& structure, Eigen::Index count);

/// TᵀMT, TᵀCT, TᵀKT, TᵀW, the same laws.
JointedStructure condense(const JointedStructure& structure, const Basis& basis);

}  // namespace jointid::response
