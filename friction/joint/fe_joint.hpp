#pragma once

#include <memory>
#include <vector>

#include "friction/joint/joint_mesh.hpp"

namespace jointid::friction {

/// What one change of load came to.
struct EquilibriumStep {
  bool found = true;          ///< false: no equilibrium, not even for the smallest step: the load is beyond the limit of the joint
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
  /// Throws InputError for a mesh that makes no sense.
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
