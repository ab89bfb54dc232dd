#pragma once

#include <utility>
#include <vector>

#include "response/fourier/joint_force.hpp"
#include "response/harmonic/harmonic_line.hpp"

namespace jointid::response {

/// One parameter of a joint, by its place in Joint::parameter_names().
struct JointParameter {
  std::size_t joint = 0, parameter = 0;
};

/// Harmonic balance condensed to the joints: R_n(Q) = Q_n − s b_n + G_n F_n(Q) = 0, s the force level. Real unknowns: those of
/// Harmonics for each joint in turn; the residual has the same layout. Its size does not depend on the number of coordinates.
class CondensedEquations {
 public:
  CondensedEquations(std::vector<Joint> joints, Harmonics harmonics);
  CondensedEquations(std::vector<JointForce> joints, Harmonics harmonics) : joints_(std::move(joints)), harmonics_(std::move(harmonics)) {}

  const Harmonics& harmonics() const { return harmonics_; }
  const std::vector<JointForce>& joints() const { return joints_; }
  void replace(std::size_t joint, Joint other) { joints_[joint] = JointForce(std::move(other)); }
  Eigen::Index unknowns() const { return at(joints_.size()) * harmonics_.unknowns(); }

  struct Value {
    Eigen::VectorXd residual;
    Eigen::MatrixXd by_motion;
  };
  Value evaluate(const HarmonicLine& line, double level, const Eigen::VectorXd& motion) const;
  /// The same with the forces that are known.
  Value evaluate(const HarmonicLine& line, double level, const Eigen::VectorXd& motion, const std::vector<ForceHarmonics>& forces) const;
  /// F of each joint with its derivatives.
  std::vector<ForceHarmonics> joint_forces(double omega, const Eigen::VectorXd& motion, bool with_parameters) const;

  /// ∂R/∂ω (the line has slopes), ∂R/∂s, ∂R/∂θ at a fixed motion.
  Eigen::VectorXd by_omega(const HarmonicLine& line, double level, const Eigen::VectorXd& motion) const;
  Eigen::VectorXd by_level(const HarmonicLine& line) const;
  Eigen::VectorXd by_parameter(const HarmonicLine& line, const Eigen::VectorXd& motion, const JointParameter& parameter) const;

  /// Joints that stick (f = k q with the stiffness of each) and joints without force.
  Eigen::VectorXd stuck(const HarmonicLine& line, double level) const;
  Eigen::VectorXd free(const HarmonicLine& line, double level) const;

  /// Q_n and F_n, [harmonic, joint].
  Eigen::MatrixXcd amplitudes(const Eigen::VectorXd& motion) const;
  Eigen::MatrixXcd forces(double omega, const Eigen::VectorXd& motion) const { return forces(omega, motion, harmonics_); }
  Eigen::MatrixXcd forces(double omega, const Eigen::VectorXd& motion, const Harmonics& of) const;

  /// ∂F_n/∂(unknowns): one matrix [joint, unknowns] for each harmonic.
  std::vector<Eigen::MatrixXcd> forces_by_motion(double omega, const Eigen::VectorXd& motion) const;

  /// The unknowns of these amplitudes, [harmonic, joint].
  Eigen::VectorXd pack(const Eigen::MatrixXcd& amplitudes) const;

 private:
  Motion motion_of(const Eigen::VectorXd& motion, Eigen::Index joint) const;

  std::vector<JointForce> joints_;
  Harmonics harmonics_;
};

}  // namespace jointid::response
