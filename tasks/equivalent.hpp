#pragma once

#include "ident/scene/equivalent_scene.hpp"
#include "tasks/equivalent_joint.hpp"

namespace jointid::tasks {

/// The joint at one amplitude of the relative displacement.
struct LevelJoint {
  std::string file;
  double displacement = 0.0;  ///< m
  std::size_t lines = 0;
  EquivalentJoint joint{};
};

/// Equivalent stiffness and damping of a friction joint against relative displacement (docs/formulas.md §12), one level after the
/// other. Only the FRFs of the joint's two ends are read. Throws InputError as frf::open() and FrfSystem, and for levels that
/// share no line with the parts on which all FRFs needed were measured.
std::vector<LevelJoint> find_equivalent(const ident::EquivalentScene& scene);

}  // namespace jointid::tasks
