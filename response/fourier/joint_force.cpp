#include "response/fourier/joint_force.hpp"

#include <numbers>
#include <utility>
#include <vector>

namespace jointid::response {

JointForce::JointForce(Joint joint) : joint_(std::move(joint)) {
  if (joint_.friction) friction_.emplace(joint_.friction);
}

std::vector<JointForce> joint_forces(const std::vector<Joint>& joints) {
  std::vector<JointForce> forces;
  for (const Joint& joint : joints) forces.emplace_back(joint);
  return forces;
}

ForceHarmonics JointForce::evaluate(const Motion& motion, double omega, const Harmonics& force, bool with_parameters) const {
  ForceHarmonics sum;
  if (friction_) {
    sum = friction_->evaluate(motion, force, with_parameters);
  } else {
    sum.force.setZero(force.size());
    sum.by_motion.setZero(force.size(), motion.harmonics().unknowns());
    sum.by_parameters.setZero(force.size(), 0);
  }
  const Eigen::Index own = sum.by_parameters.cols();
  sum.by_parameters.conservativeResize(force.size(), own + (with_parameters ? 3 : 0));
  if (with_parameters) sum.by_parameters.rightCols(3).setZero();
  add_linear(motion, omega, sum, force, with_parameters);
  if (joint_.cubic != 0.0 || with_parameters) add_cubic(motion, sum, force, with_parameters);
  return sum;
}

void JointForce::add_linear(const Motion& motion, double omega, ForceHarmonics& sum, const Harmonics& force,
                            bool with_parameters) const {
  for (Eigen::Index n = 0; n < force.size(); ++n) {
    const Eigen::Index m = motion.harmonics().find(force[n]);
    if (m < 0) continue;
    const Complex amplitude = motion.amplitudes()(m), rate = {0.0, omega * force[n]},
                  factor = joint_.stiffness + rate * joint_.damping;
    const Eigen::Index column = motion.harmonics().offset(m);
    sum.force(n) += factor * amplitude;
    sum.by_motion(n, column) += factor;
    if (force[n] > 0) sum.by_motion(n, column + 1) += factor * Complex(0.0, 1.0);
    if (!with_parameters) continue;
    const Eigen::Index last = sum.by_parameters.cols();
    sum.by_parameters(n, last - 3) += amplitude;
    sum.by_parameters(n, last - 2) += rate * amplitude;
  }
}

/// q³ has harmonics up to three times those of q; its product with that of the force is summed exactly by more points than both
/// together.
void JointForce::add_cubic(const Motion& motion, ForceHarmonics& sum, const Harmonics& force, bool with_parameters) const {
  const int points = 3 * motion.harmonics().largest() + force.largest() + 1;
  std::vector<Complex> powers(static_cast<std::size_t>(force.largest()) + 1);
  for (int i = 0; i < points; ++i) {
    const double theta = 2.0 * std::numbers::pi * i / points, q = motion.value(theta);
    Eigen::RowVectorXcd slope;
    if (joint_.cubic != 0.0) slope = (3.0 * q * q * motion.by_unknowns(theta)).transpose().cast<Complex>();
    fill_powers(theta, powers);
    for (Eigen::Index n = 0; n < force.size(); ++n) {
      const Complex factor = (force[n] == 0 ? 1.0 : 2.0) / points * std::conj(powers[static_cast<std::size_t>(force[n])]);
      if (with_parameters) sum.by_parameters(n, sum.by_parameters.cols() - 1) += q * q * q * factor;
      if (joint_.cubic == 0.0) continue;
      sum.force(n) += joint_.cubic * q * q * q * factor;
      sum.by_motion.row(n) += joint_.cubic * factor * slope;
    }
  }
}

Eigen::VectorXcd JointForce::by_omega(const Motion& motion, const Harmonics& force) const {
  Eigen::VectorXcd change = Eigen::VectorXcd::Zero(force.size());
  for (Eigen::Index n = 0; n < force.size(); ++n) {
    const Eigen::Index m = motion.harmonics().find(force[n]);
    if (m >= 0) change(n) = Complex(0.0, force[n] * joint_.damping) * motion.amplitudes()(m);
  }
  return change;
}

}  // namespace jointid::response
