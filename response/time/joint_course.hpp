#pragma once

#include <memory>
#include <vector>

#include "response/time/joint_state.hpp"
#include "response/time/linear_flow.hpp"

namespace jointid::response {

using JointStates = std::vector<std::unique_ptr<JointState>>;

/// The joints' motion from one state on, their pieces frozen: for any length h up to LinearFlow::longest_step() the forces of the
/// curved joints are the polynomial that meets their laws at Gauss's points (collocation, order 16 at the end of the step),
/// found by Newton's method; on straight pieces the motion is exact.
class JointCourse {
 public:
  /// `flow` and `states` must outlive it.
  JointCourse(LinearFlow& flow, const Eigen::VectorXd& z, const JointStates& states);

  /// The motion up to h; false when the equations of the curved joints are not met.
  bool solve(double h);

  double length() const { return length_; }
  /// q, q̇, q̈ of every joint at the end.
  const Eigen::VectorXd& q() const { return motion_[0]; }
  const Eigen::VectorXd& velocity() const { return motion_[1]; }
  const Eigen::VectorXd& acceleration() const { return motion_[2]; }
  /// The same at the beginning.
  const Eigen::VectorXd& start(int derivative) const { return start_[static_cast<std::size_t>(derivative)]; }

  /// Forces of the curved joints at Gauss's points, one joint after the other, and the derivatives df/dq there.
  const Eigen::VectorXd& node_forces() const { return forces_; }
  const Eigen::VectorXd& node_tangents() const { return tangents_; }
  const Eigen::VectorXd& node_displacements() const { return node_q_; }
  /// q at Gauss's points by those forces.
  const Eigen::MatrixXd& influence() const { return influence_; }
  /// Curved joints × powers of σ = τ/h.
  Eigen::MatrixXd force_series() const;

  /// How far the forces' polynomials, continued to the end of the step, are from the laws: the largest difference, in parts of
  /// the forces' size (of springs, or of the force that accelerates them).
  double mismatch() const;

 private:
  void free_motion(double h);
  bool meet_laws(double h);
  double inertia(Eigen::Index joint, Eigen::Index curved) const;

  LinearFlow* flow_;
  const JointStates* states_;
  std::vector<Eigen::VectorXd> taylor_;  ///< WᵀA^k z/k!
  double length_ = 0.0;
  Eigen::VectorXd start_[3], motion_[3];
  Eigen::VectorXd forces_, tangents_, node_q_;
  Eigen::MatrixXd influence_;
};

}  // namespace jointid::response
