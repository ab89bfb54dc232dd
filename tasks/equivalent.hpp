#pragma once

#include "ident/result/control.hpp"
#include "ident/scene/equivalent_scene.hpp"
#include "tasks/equivalent_joint.hpp"

namespace jointid::tasks {

/// The joint at one amplitude of the relative displacement.
struct LevelJoint {
  std::string file;
  double displacement = 0.0;  ///< amplitude of the relative displacement at the joint, m
  std::size_t lines = 0;      ///< lines with all necessary FRFs
  EquivalentJoint joint{};
};

/// Equivalent stiffness and damping of a friction joint over relative displacement (docs/formulas.md §12), one force level after
/// the other. Only the FRFs of the joint's two ends are read. Throws InputError as frf::open() and FrfSystem, and for force
/// levels without a common line of the parts with all necessary FRFs. Interrupted between levels it throws Interrupted;
/// `progress` gets a stage without lines.
std::vector<LevelJoint> find_equivalent(const ident::EquivalentScene& scene, const ident::Control& control = {});

/// Whether every force level has a result.
bool all_settled(const std::vector<tasks::LevelJoint>& levels);

/// "ok"; "doubtful" if equivalent_doubt() is not empty; "not_usable" if a force level did not converge.
std::string equivalent_status(const std::vector<tasks::LevelJoint>& levels);

/// Reason to doubt the values by their own errors: a force level without a passive joint or with an unknown stiffness, or damping
/// that most force levels do not determine. Empty: none.
std::string equivalent_doubt(const std::vector<tasks::LevelJoint>& levels);

}  // namespace jointid::tasks
