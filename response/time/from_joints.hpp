#pragma once

#include "response/joint/joint.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// The structure as time marching takes it: springs and dashpots of the joints go into K and C (K + W k Wᵀ, C + W c Wᵀ), friction
/// elements stay, in their order, and behind them cubic springs. `w`: N × joints.
JointedStructure from_joints(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints);

/// Which joints have friction elements, and which cubic springs: the columns of the result's W are of the former, then the latter.
std::vector<std::size_t> friction_joints(const std::vector<Joint>& joints);
std::vector<std::size_t> cubic_joints(const std::vector<Joint>& joints);

}  // namespace jointid::response
