#pragma once

#include "response/joint/joint.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// The structure as time marching takes it: springs and dashpots of the joints go into K and C (K + W k Wᵀ, C + W c Wᵀ), friction
/// elements stay, in their order. `w`: N × joints. Throws InputError (usage) for a cubic spring, which marching does not have.
JointedStructure from_joints(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints);

/// Which joints have friction elements: column j of the result's W is that of joint [j].
std::vector<std::size_t> friction_joints(const std::vector<Joint>& joints);

}  // namespace jointid::response
