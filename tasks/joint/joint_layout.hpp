#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tasks/joint/joint_plate.hpp"
#include "tasks/joint/node_pairs.hpp"

namespace jointid::tasks {

/// What is unknown between the pairs of nodes of a joint.
enum class JointForm {
  springs,        ///< a spring for every pair and direction
  equal_springs,  ///< the pairs are alike: a spring for every direction
  full,           ///< symmetric matrices over all DOFs
  plate           ///< two rigid plates: a spring for each of the six motions between their virtual points
};

/// A joint by the pairs of nodes that it joins.
struct JointLayout {
  std::vector<NodePair> pairs;  ///< with the directions that are joined
  JointForm form = JointForm::springs;
  bool damping = true;  ///< hysteretic, as many unknowns as the stiffness
  std::optional<Plate> plate{};  ///< of that form
};

/// Above so many unknowns a joint deserves a second look: few tests determine them.
inline constexpr std::size_t many_unknowns = 100;

/// The DOFs on both sides (of a plate: of its virtual points), by node and direction, none twice. Their signs are positive, so that
/// springs act along the same axis whatever way the sensors point.
std::vector<frf::Dof> dofs_of(const JointLayout& layout);

/// Unknowns of its matrices together.
std::size_t unknowns_of(const JointLayout& layout);

/// The value of the key `springs` of a scene; empty where the form is full, or there is no direction.
std::string springs_text(const JointLayout& layout);

}  // namespace jointid::tasks
