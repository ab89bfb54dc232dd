#include "response/harmonic/condensed_equations.hpp"

#include <utility>

#include "dense/lu.hpp"

namespace jointid::response {

CondensedEquations::CondensedEquations(std::vector<Joint> joints, Harmonics harmonics) : harmonics_(std::move(harmonics)) {
  for (Joint& joint : joints) joints_.emplace_back(std::move(joint));
}

Motion CondensedEquations::motion_of(const Eigen::VectorXd& motion, Eigen::Index joint) const {
  const Eigen::Index size = harmonics_.unknowns();
  return {harmonics_, harmonics_.unpack(motion.segment(joint * size, size))};
}

Eigen::VectorXd CondensedEquations::pack(const Eigen::MatrixXcd& amplitudes) const {
  const Eigen::Index size = harmonics_.unknowns();
  Eigen::VectorXd motion(unknowns());
  for (Eigen::Index j = 0; j < amplitudes.cols(); ++j) motion.segment(j * size, size) = harmonics_.pack(amplitudes.col(j));
  return motion;
}

Eigen::MatrixXcd CondensedEquations::amplitudes(const Eigen::VectorXd& motion) const {
  const Eigen::Index size = harmonics_.unknowns();
  Eigen::MatrixXcd q(harmonics_.size(), at(joints_.size()));
  for (Eigen::Index j = 0; j < q.cols(); ++j) q.col(j) = harmonics_.unpack(motion.segment(j * size, size));
  return q;
}

CondensedEquations::Value CondensedEquations::evaluate(const HarmonicLine& line, double level,
                                                       const Eigen::VectorXd& motion) const {
  return evaluate(line, level, motion, joint_forces(line.omega, motion, false));
}

std::vector<ForceHarmonics> CondensedEquations::joint_forces(double omega, const Eigen::VectorXd& motion, bool with_parameters) const {
  std::vector<ForceHarmonics> forces;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    forces.push_back(joints_[j].evaluate(motion_of(motion, at(j)), omega, harmonics_, with_parameters));
  return forces;
}

CondensedEquations::Value CondensedEquations::evaluate(const HarmonicLine& line, double level, const Eigen::VectorXd& motion,
                                                       const std::vector<ForceHarmonics>& forces) const {
  const Eigen::Index size = harmonics_.unknowns(), count = at(joints_.size());
  Eigen::MatrixXcd residual = amplitudes(motion);
  Value value;
  value.by_motion = Eigen::MatrixXd::Identity(unknowns(), unknowns());
  for (Eigen::Index n = 0; n < harmonics_.size(); ++n)
    residual.row(n) -= level * line.harmonics[static_cast<std::size_t>(n)].driven.transpose();
  for (Eigen::Index j = 0; j < count; ++j) {
    const ForceHarmonics& force = forces[static_cast<std::size_t>(j)];
    for (Eigen::Index n = 0; n < harmonics_.size(); ++n) {
      const Eigen::MatrixXcd& g = line.harmonics[static_cast<std::size_t>(n)].joints;
      for (Eigen::Index i = 0; i < count; ++i) {
        residual(n, i) += g(i, j) * force.force(n);
        const Eigen::Index row = i * size + harmonics_.offset(n);
        for (Eigen::Index u = 0; u < size; ++u) {
          const Complex change = g(i, j) * force.by_motion(n, u);
          value.by_motion(row, j * size + u) += change.real();
          if (harmonics_[n] > 0) value.by_motion(row + 1, j * size + u) += change.imag();
        }
      }
    }
  }
  value.residual = pack(residual);
  return value;
}

/// W_ᵀH′(WF − sP)n per harmonic, and G_n ∂F_n/∂ω of dashpots.
Eigen::VectorXd CondensedEquations::by_omega(const HarmonicLine& line, double level, const Eigen::VectorXd& motion) const {
  const Eigen::MatrixXcd force = forces(line.omega, motion);
  Eigen::MatrixXcd force_slope(force.rows(), force.cols()), slope(force.rows(), force.cols());
  for (Eigen::Index j = 0; j < force.cols(); ++j) {
    force_slope.col(j) = joints_[static_cast<std::size_t>(j)].by_omega(motion_of(motion, j), harmonics_);
  }
  for (Eigen::Index n = 0; n < force.rows(); ++n) {
    const HarmonicLine::One& now = line.harmonics[static_cast<std::size_t>(n)];
    const HarmonicLine::One& change = line.slopes[static_cast<std::size_t>(n)];
    const Eigen::VectorXcd f = force.row(n).transpose(), df = force_slope.row(n).transpose();
    slope.row(n) = (change.joints * f - level * change.driven + now.joints * df).transpose();
  }
  return pack(slope);
}

Eigen::VectorXd CondensedEquations::by_level(const HarmonicLine& line) const {
  Eigen::MatrixXcd slope(harmonics_.size(), at(joints_.size()));
  for (Eigen::Index n = 0; n < slope.rows(); ++n) slope.row(n) = -line.harmonics[static_cast<std::size_t>(n)].driven.transpose();
  return pack(slope);
}

Eigen::VectorXd CondensedEquations::by_parameter(const HarmonicLine& line, const Eigen::VectorXd& motion,
                                                 const JointParameter& parameter) const {
  const Eigen::Index j = at(parameter.joint);
  const ForceHarmonics force = joints_[parameter.joint].evaluate(motion_of(motion, j), line.omega, harmonics_, true);
  Eigen::MatrixXcd slope(harmonics_.size(), at(joints_.size()));
  for (Eigen::Index n = 0; n < slope.rows(); ++n) {
    slope.row(n) =
        (line.harmonics[static_cast<std::size_t>(n)].joints.col(j) * force.by_parameters(n, at(parameter.parameter))).transpose();
  }
  return pack(slope);
}

Eigen::VectorXd CondensedEquations::stuck(const HarmonicLine& line, double level) const {
  const Eigen::Index count = at(joints_.size());
  Eigen::MatrixXcd q(harmonics_.size(), count);
  for (Eigen::Index n = 0; n < q.rows(); ++n) {
    const HarmonicLine::One& one = line.harmonics[static_cast<std::size_t>(n)];
    Eigen::VectorXcd stiffness(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Joint& joint = joints_[static_cast<std::size_t>(j)].joint();
      stiffness(j) = Complex(joint.stuck_stiffness(), harmonics_[n] * line.omega * joint.damping);
    }
    const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(count, count) + one.joints * stiffness.asDiagonal();
    q.row(n) = level * dense::solve(system, one.driven).transpose();
  }
  return pack(q);
}

Eigen::VectorXd CondensedEquations::free(const HarmonicLine& line, double level) const { return -level * by_level(line); }

Eigen::MatrixXcd CondensedEquations::forces(double omega, const Eigen::VectorXd& motion, const Harmonics& of) const {
  Eigen::MatrixXcd force(of.size(), at(joints_.size()));
  for (Eigen::Index j = 0; j < force.cols(); ++j) {
    force.col(j) = joints_[static_cast<std::size_t>(j)].evaluate(motion_of(motion, j), omega, of).force;
  }
  return force;
}

std::vector<Eigen::MatrixXcd> CondensedEquations::forces_by_motion(double omega, const Eigen::VectorXd& motion) const {
  const Eigen::Index size = harmonics_.unknowns();
  std::vector<Eigen::MatrixXcd> slopes(static_cast<std::size_t>(harmonics_.size()),
                                       Eigen::MatrixXcd::Zero(at(joints_.size()), unknowns()));
  for (Eigen::Index j = 0; j < at(joints_.size()); ++j) {
    const ForceHarmonics force = joints_[static_cast<std::size_t>(j)].evaluate(motion_of(motion, j), omega, harmonics_);
    for (Eigen::Index n = 0; n < harmonics_.size(); ++n) {
      slopes[static_cast<std::size_t>(n)].row(j).segment(j * size, size) = force.by_motion.row(n);
    }
  }
  return slopes;
}

}  // namespace jointid::response
