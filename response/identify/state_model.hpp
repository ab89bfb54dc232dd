#pragma once

#include <memory>
#include <vector>

#include "response/harmonic/harmonic_balance.hpp"
#include "response/identify/measured_state.hpp"

namespace jointid::response {

/// What harmonic balance says of a measured state.
struct StatePrediction {
  HarmonicSolution solution;  ///< the harmonics of the model; no answer unless it converged
  Eigen::MatrixXcd response;  ///< X_n at the measured harmonics, [harmonic, response]
  /// ∂X_n by each parameter, as `response`; dX = −HW(F_Q dQ + F_θ dθ), dQ = −J⁻¹GF_θ dθ by the implicit function theorem.
  std::vector<Eigen::MatrixXcd> by_parameter;
  std::vector<ForceHarmonics> forces{};  ///< of each joint, with derivatives by its own motion and parameters
};

/// One measured state and the receptances that its prediction needs, looked up once.
class StateModel {
 public:
  /// Solves for the measured harmonics and those of `harmonics` that the structure covers. The state must be valid.
  StateModel(std::shared_ptr<const Receptance> structure, const MeasuredState& state, const std::vector<int>& harmonics);

  const MeasuredState& state() const { return state_; }

  /// Starts at the motion of `last` if it is given and converged.
  StatePrediction predict(const std::vector<JointForce>& joints, const std::vector<JointParameter>& parameters,
                          const HarmonicSolution* last = nullptr) const;

  /// Of the model.
  const Harmonics& harmonics() const { return harmonics_; }
  const HarmonicLine& line() const { return line_; }

  /// Of numbers at the model's harmonics those at the measured ones.
  Eigen::MatrixXcd measured(const Eigen::MatrixXcd& of_model) const;

  /// δu = δH(P − WF) of each of the structure's errors at one harmonic, one deviation of its real part and one of its imaginary
  /// part; of each element Re and Im. [2 · (joints + responses), 2 · errors]
  Eigen::MatrixXd error_shares(int harmonic, const Eigen::VectorXcd& joint_force) const;

  /// The same of the errors of the measured forces at one harmonic n ≥ 1: δu = H δP, one deviation of Re and one of Im of each
  /// force. [2 · (joints + responses), 2 · forces]
  Eigen::MatrixXd force_shares(int harmonic) const;

 private:
  friend class ReceptanceResponse;
  void differentiate(const CondensedEquations& equations, const Eigen::VectorXd& motion,
                     const std::vector<JointParameter>& parameters, StatePrediction& prediction) const;
  /// −HW F_Q of one harmonic of the model. [response, motions of all joints]
  Eigen::MatrixXcd by_motion(const CondensedEquations& equations, Eigen::Index harmonic,
                             const std::vector<ForceHarmonics>& forces) const;

  std::shared_ptr<const Receptance> structure_;
  MeasuredState state_;
  Harmonics harmonics_;
  HarmonicLine line_;
};

/// What the structure's errors change of the measured responses at one prediction, to first order: δu = δH(P − WF),
/// (I + G F_Q) δQ = Wᵀδu, δX = δu − HW F_Q δQ. The model, joints and prediction must outlive it.
class ReceptanceResponse {
 public:
  ReceptanceResponse(const StateModel& model, const std::vector<JointForce>& joints, const StatePrediction& prediction);

  /// In deviations of the responses; two columns for each of the errors at that harmonic of the model, one deviation of its real
  /// part and one of its imaginary part. [measured numbers, 2 · errors]
  Eigen::MatrixXd by_errors(int harmonic) const;

  /// The same of the errors of the measured forces at it.
  Eigen::MatrixXd by_forces(int harmonic) const;

 private:
  /// Of δu at one harmonic, given as StateModel::error_shares does.
  Eigen::MatrixXd by_shares(int harmonic, const Eigen::MatrixXd& shares) const;

  const StateModel& model_;
  const StatePrediction& prediction_;
  Eigen::MatrixXd by_joints_;  ///< −HW F_Q (I + G F_Q)⁻¹ in deviations, of Wᵀδu as CondensedEquations packs it
};

}  // namespace jointid::response
