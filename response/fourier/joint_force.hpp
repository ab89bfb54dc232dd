#pragma once

#include <optional>
#include <vector>

#include "response/fourier/masing_fourier.hpp"
#include "response/joint/joint.hpp"

namespace jointid::response {

/// Fourier integrals of the force of a joint (joint.hpp): its friction element event-exact, spring and dashpot by F_n = (k +
/// inωc)Q_n, the cubic spring by the trapezoidal rule with more points than its highest harmonic, which is exact.
class JointForce {
 public:
  explicit JointForce(Joint joint);

  const Joint& joint() const { return joint_; }

  /// `omega`: of the first harmonic, rad/s. Parameters are those of Joint::parameter_names().
  ForceHarmonics evaluate(const Motion& motion, double omega, const Harmonics& force, bool with_parameters = false) const;

  /// ∂F/∂ω at a fixed motion, of the dashpot.
  Eigen::VectorXcd by_omega(const Motion& motion, const Harmonics& force) const;

 private:
  void add_linear(const Motion& motion, double omega, ForceHarmonics& sum, const Harmonics& force, bool with_parameters) const;
  void add_cubic(const Motion& motion, ForceHarmonics& sum, const Harmonics& force, bool with_parameters) const;

  Joint joint_;
  std::optional<MasingFourier> friction_;
};

/// Of each joint.
std::vector<JointForce> joint_forces(const std::vector<Joint>& joints);

}  // namespace jointid::response
