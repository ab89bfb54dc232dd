#pragma once

#include <memory>
#include <span>
#include <vector>

#include "friction/element.hpp"

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
JointMesh uniform_mesh(MemberKind kind, std::size_t count, const Member& whole, std::shared_ptr<const Element> interface);

enum class EquilibriumStatus {
  ok,
  no_equilibrium  ///< not even for the smallest step: the load is beyond the limit of the joint
};

/// What one change of load came to.
struct EquilibriumStep {
  EquilibriumStatus status = EquilibriumStatus::ok;
  double force = 0.0;         ///< at the last node
  double displacement = 0.0;  ///< of the last node
  int steps = 0;              ///< into which the change was divided
  int iterations = 0;         ///< of Newton's method, all steps together
};

struct EquilibriumControl {
  double tolerance = 1e-11;     ///< converged when max|residual| ≤ tolerance · max(load, nodal force of the interface) + rounding
  int iterations = 60;          ///< for one step; then it is halved
  double smallest_step = 1e-6;  ///< of the change of load; below it there is no equilibrium
};

/// Static equilibrium under any history of load: incremental Newton with line search on the convex potential of each step, steps
/// halved when it does not converge. Every interface node follows its own Masing path.
class FiniteElementJoint {
 public:
  /// Throws std::invalid_argument for a mesh that makes no sense.
  explicit FiniteElementJoint(JointMesh mesh, const EquilibriumControl& control = {});
  ~FiniteElementJoint();
  FiniteElementJoint(FiniteElementJoint&&) noexcept;
  FiniteElementJoint& operator=(FiniteElementJoint&&) noexcept;

  /// Goes to this force at the last node. Without equilibrium it stays at the last one found.
  EquilibriumStep load_to(double force);

  /// Goes to this displacement of the last node; there always is an equilibrium.
  EquilibriumStep move_to(double displacement);

  /// Displacements of the nodes along the interface.
  std::vector<double> displacements() const;

  /// Forces of the interface on the nodes, positive against +u. In equilibrium their sum is the load less end_spring·u₀.
  std::vector<double> interface_forces() const;

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace jointid::friction
