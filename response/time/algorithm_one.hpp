#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "response/time/exact_march.hpp"
#include "response/time/joint_path.hpp"

namespace jointid::response {

/// How the equations of a step are solved.
enum class StepIteration {
  newton,  ///< never fails
  direct  ///< (3.21), Newmark's method as it stands: q ← q_lin − G f(q) from the last step; diverges where ρ(G ∂f/∂q) ≥ 1
};

/// Implicit time marching with the average acceleration (Ren 1992, 3.22–3.27 with γ = 0, β = −½), condensed to the joints
/// (response.md §2): with S = 4M/Δ² + 2C/Δ + K factored once, a step is q + G f(q) = q_lin, G = WᵀS⁻¹W, the minimum of a strictly
/// convex function of J unknowns, which Newton's method with a line search always finds. Of order 2, without numerical damping:
/// where Δ is far above 1/ω of a mode, that mode rings. Turns of a joint inside a step are not seen.
class AlgorithmOne {
 public:
  /// From rest at t = 0 in steps of `delta` s. `loads`: a normal load for each joint, or none. Throws InputError (check()).
  AlgorithmOne(JointedStructure structure, ForceHistory force, double delta, const std::vector<NormalLoad>& loads = {},
               StepIteration iteration = StepIteration::newton);

  void step();

  const Instant& motion() const { return motion_; }
  /// Linear systems of J unknowns solved so far.
  std::size_t solutions() const { return solutions_; }
  /// Largest number of them in one step.
  std::size_t most_solutions() const { return most_solutions_; }
  /// Largest ‖f(q) − λ‖ that was left, in parts of the largest force of the step.
  double residual() const { return residual_; }
  /// Whether a direct iteration did not end within 200 steps of 1e-10 of the motion; the motion is then of no use.
  bool diverged() const { return diverged_; }

 private:
  struct Joints {
    Eigen::VectorXd force, tangent;
  };
  Joints joints_at(const Eigen::VectorXd& q) const;
  Eigen::VectorXd solve_joints(const Eigen::VectorXd& q_linear);
  Eigen::VectorXd iterate_joints(const Eigen::VectorXd& q_linear);
  double step_length(const Eigen::VectorXd& q, const Eigen::VectorXd& lambda, const Eigen::VectorXd& dlambda) const;

  JointedStructure structure_;
  ForceHistory force_;
  double delta_;
  Eigen::MatrixXd lower_;        ///< Cholesky factor of S
  Eigen::MatrixXd columns_;      ///< S⁻¹W
  Eigen::MatrixXd flexibility_;  ///< G
  std::vector<JointPath> paths_;
  Instant motion_;
  Eigen::VectorXd acceleration_, initial_stiffness_;
  std::size_t steps_ = 0, solutions_ = 0, most_solutions_ = 0;
  double residual_ = 0.0;
  StepIteration iteration_;
  bool diverged_ = false;
};

}  // namespace jointid::response
