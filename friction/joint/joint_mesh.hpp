#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// A part of the joint component between two nodes.
struct Member {
  double length = 0.0;     ///< m
  double stiffness = 0.0;  ///< EA (N) of a bar, EI (N·m²) of a beam
};

enum class MemberKind {
  bar,  ///< axial; the interface acts along it
  beam  ///< bending (Euler); the interface acts across it
};

/// One-dimensional joint component on a rigid base (docs/formulas.md §10e). The interface law per length of every node acts there
/// with half of the neighbouring members' lengths, as in case One. Loaded at its last node.
struct JointMesh {
  MemberKind kind = MemberKind::bar;
  std::vector<Member> members;
  std::vector<std::shared_ptr<const Element>> interface;  ///< one for each node, force per length; null = no contact
  double end_spring = 0.0;                                ///< N/m at the first node
};

/// `count` equal members with the same interface.
JointMesh uniform_mesh(MemberKind kind, std::size_t count, const Member& whole, const std::shared_ptr<const Element>& interface);

}  // namespace jointid::friction
