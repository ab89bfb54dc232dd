#pragma once

#include <memory>
#include <vector>

#include "friction/path/element.hpp"
#include "response/structure/matrix_structure.hpp"
#include "response/time/force_history.hpp"

namespace jointid::response {

/// A structure with friction joints: M ẍ + C ẋ + K x + W f(q) = p(t), q = Wᵀx. A column of W is the relative coordinate of a
/// joint (+1 and −1, or one ±1 for a joint to ground), f_j its force on the positive end. A CubicSpring may stand for a law.
struct JointedStructure {
  MatrixStructure matrices;
  Eigen::MatrixXd incidence;                                   ///< W, N × J
  std::vector<std::shared_ptr<const friction::Element>> laws;  ///< J of them

  Eigen::Index coordinates() const { return matrices.mass.rows(); }
  Eigen::Index joints() const { return incidence.cols(); }

  /// dT/du(0) of every joint, N/m.
  Eigen::VectorXd initial_stiffness() const;
};

/// Throws InputError unless sizes fit, every number is finite, and the mass matrix is positive definite.
void check(const JointedStructure& structure);

/// The same, and unless the force has a row for each coordinate.
void check(const JointedStructure& structure, const ForceHistory& force);

/// Throws InputError unless a time step is above 0 and finite.
void check_step(double delta);

}  // namespace jointid::response
