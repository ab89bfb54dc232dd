#pragma once

#include "ident/result/control.hpp"
#include "ident/scene/equivalent_scene.hpp"
#include "tasks/equivalent_joint.hpp"

namespace jointid::tasks {

/// The joint at one amplitude of the relative displacement.
struct LevelJoint {
  std::string file;
  double displacement = 0.0;  ///< amplitude of the relative displacement at the joint, m
  std::size_t lines = 0;      ///< on which all FRFs needed were measured
  EquivalentJoint joint{};
};

/// Equivalent stiffness and damping of a friction joint against relative displacement (docs/formulas.md §12), one level after the
/// other. Only the FRFs of the joint's two ends are read. Throws InputError as frf::open() and FrfSystem, and for levels that
/// share no line with the parts on which all FRFs needed were measured.
/// Interrupted between levels it throws Interrupted; `progress` is told a stage without lines.
std::vector<LevelJoint> find_equivalent(const ident::EquivalentScene& scene, const ident::Control& control = {});

/// Whether every level has an answer.
bool all_settled(const std::vector<tasks::LevelJoint>& levels);

/// "ok"; "doubtful" where equivalent_doubt() says something; "not_usable" where a level did not settle.
std::string equivalent_status(const std::vector<tasks::LevelJoint>& levels);

/// What speaks against the values by their own errors: a level with no passive joint or an unknown stiffness, or damping that
/// most levels do not tell. Empty: nothing.
std::string equivalent_doubt(const std::vector<tasks::LevelJoint>& levels);

}  // namespace jointid::tasks
