#pragma once

#include <string>
#include <vector>

#include "coupling/assembly.hpp"
#include "ident/identify.hpp"
#include "ident/scene/couple_scene.hpp"

namespace jointid::tasks {

/// The joint of a solution for coupling, over `dofs` (in the order of Solution::dofs; empty: by the same names). With `uncertainty`, of
/// method "likelihood", its errors, and what they have in common with the FRFs of the parts named `shared`, whose FRFs are those that it
/// was found from (ident::JointErrors). Throws InputError for a joint that is not one matrix for all lines, and as joint_errors().
coupling::KnownJoint identified_joint(const ident::Plan& plan, const ident::Solution& solution, std::vector<coupling::PlacedDof> dofs,
                                      const std::vector<std::string>& shared, bool uncertainty, const ident::Control& control = {});

/// A joint, and a sentence on where it came from.
struct FoundJoint {
  coupling::KnownJoint joint;
  std::string note;
};

/// Solves the scene of a joint of `scene`. Throws InputError where it has no usable solution.
FoundJoint identify_joint(const ident::CoupleScene& scene, const ident::IdentifiedJoint& joint, const ident::Control& control);

}  // namespace jointid::tasks
