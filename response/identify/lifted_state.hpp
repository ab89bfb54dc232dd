#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/identify/law_unknowns.hpp"
#include "response/identify/state_model.hpp"

namespace jointid::response {

/// Rows of one state: of each measured response (as in_deviations), then (F_n − F_n(Q; θ))/tolerance of each joint and harmonic.
struct LiftedRows {
  Eigen::VectorXd residual;
  Eigen::MatrixXd by_parameter;  ///< numbers of LawUnknowns
  Eigen::MatrixXd by_force;      ///< Re and Im of F_n, as CondensedEquations packs them
};

/// A measured state with the forces F_n of its joints as unknowns of their own: motion Q_n = b_n − G_nF_n and response X_n = HP_n
/// − HWF_n follow from them without an equation to solve, and the law says F = F(Q; θ) up to a tolerance.
class LiftedState {
 public:
  /// `tolerance`: standard deviation in N that is given to the law's forces of each joint. rows() and by_errors() need derivatives.
  LiftedState(const StateModel& model, const std::vector<JointForce>& joints, const Eigen::MatrixXcd& force,
              const Eigen::VectorXd& tolerance, bool with_derivatives);

  /// Q_n of these forces, [harmonic, joint].
  static Eigen::MatrixXcd motion(const StateModel& model, const Eigen::MatrixXcd& force);

  Eigen::VectorXd residual() const;
  LiftedRows rows(const LawUnknowns& unknowns, const Eigen::VectorXd& slopes) const;
  /// What the structure's errors at one harmonic do to the rows, two columns each. [rows, 2 · errors]
  Eigen::MatrixXd by_errors(int harmonic) const;
  /// The same of the errors of the measured forces at it. [rows, 2 · forces]
  Eigen::MatrixXd by_forces(int harmonic) const;

 private:
  /// Adds to these columns of rows what changes of Q_n and X_n at one harmonic do, given as Re and Im of each joint, then response.
  void add_moved(Eigen::Index harmonic, const Eigen::MatrixXd& moved, Eigen::Ref<Eigen::MatrixXd> columns) const;

  Eigen::MatrixXd moved_rows(Eigen::Index harmonic, const Eigen::MatrixXd& shares) const;

  const StateModel& model_;
  CondensedEquations equations_;
  const Eigen::MatrixXcd& force_;
  const Eigen::VectorXd& tolerance_;
  Eigen::VectorXd weight_;  ///< 1/tolerance of each packed force
  std::vector<ForceHarmonics> law_;
  Eigen::MatrixXd stiffness_;  ///< ∂F/∂Q, both packed
};

}  // namespace jointid::response
