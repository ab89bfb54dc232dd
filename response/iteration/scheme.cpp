#include "response/iteration/scheme.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "dense/eigen.hpp"
#include "dense/lu.hpp"
#include "minimise/least_value.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Forces of a motion and the scheme's K, both [harmonic, joint].
struct Linearised {
  MatrixXcd motion, force, stiffness;
};

/// ∂F_n/∂Re Q_n and ∂F_n/∂Im Q_n of one joint.
std::pair<Complex, Complex> own_slopes(const ForceHarmonics& force, const Harmonics& harmonics, Index n) {
  const Index place = harmonics.offset(n);
  return {force.by_motion(n, place), harmonics[n] > 0 ? force.by_motion(n, place + 1) : Complex(0.0)};
}

/// (4.58): a harmonic without motion takes the phase 0, the mean has none.
Complex local_stiffness(const ForceHarmonics& force, const Harmonics& harmonics, Index n, Complex q) {
  const auto [by_real, by_imaginary] = own_slopes(force, harmonics, n);
  if (harmonics[n] == 0 || std::abs(q) == 0.0) return by_real;
  const Complex direction = q / std::abs(q);
  return std::conj(direction) * (direction.real() * by_real + direction.imag() * by_imaginary);
}

Complex wirtinger_stiffness(const ForceHarmonics& force, const Harmonics& harmonics, Index n) {
  const auto [by_real, by_imaginary] = own_slopes(force, harmonics, n);
  return harmonics[n] == 0 ? by_real : 0.5 * (by_real - Complex(0.0, 1.0) * by_imaginary);
}

Complex stiffness_of(Scheme scheme, const ForceHarmonics& force, const Harmonics& harmonics, Index n, Complex q) {
  switch (scheme) {
    case Scheme::direct:
      return 0.0;
    case Scheme::equivalent:
      return std::abs(q) > 0.0 ? force.force(n) / q : own_slopes(force, harmonics, n).first;
    case Scheme::local:
      return local_stiffness(force, harmonics, n, q);
    case Scheme::wirtinger:
      return wirtinger_stiffness(force, harmonics, n);
  }
  return 0.0;
}

Linearised linearised(Scheme scheme, const CondensedEquations& equations, const std::vector<ForceHarmonics>& forces,
                      const VectorXd& motion) {
  Linearised out;
  out.motion = equations.amplitudes(motion);
  out.force = out.stiffness = MatrixXcd::Zero(out.motion.rows(), out.motion.cols());
  for (Index j = 0; j < out.motion.cols(); ++j) {
    const ForceHarmonics& force = forces[static_cast<std::size_t>(j)];
    for (Index n = 0; n < out.motion.rows(); ++n) {
      out.force(n, j) = force.force(n);
      out.stiffness(n, j) = stiffness_of(scheme, force, equations.harmonics(), n, out.motion(n, j));
    }
  }
  return out;
}

/// I + G_nK_n.
MatrixXcd system_of(const Linearised& at, const HarmonicLine& line, Index n) {
  const MatrixXcd& g = line.harmonics[static_cast<std::size_t>(n)].joints;
  return MatrixXcd::Identity(g.rows(), g.cols()) + g * at.stiffness.row(n).transpose().asDiagonal();
}

}  // namespace

std::string_view word(Scheme scheme) {
  switch (scheme) {
    case Scheme::direct:
      return "direct iteration";
    case Scheme::equivalent:
      return "ESD";
    case Scheme::local:
      return "LESD";
    case Scheme::wirtinger:
      return "LESD, both directions";
  }
  return "";
}

std::string_view word(IterationState state) {
  switch (state) {
    case IterationState::converged:
      return "converged";
    case IterationState::stalled:
      return "stalled";
    case IterationState::limit:
      return "limit";
  }
  return "";
}

bool defined(Scheme scheme, const CondensedEquations& equations) {
  return scheme != Scheme::equivalent || equations.harmonics().size() == 1;
}

VectorXd stepped(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line, double level,
                 const VectorXd& motion) {
  if (!defined(scheme, equations))
    jointid::refuse("ESD has an equivalent stiffness for one harmonic alone; take LESD for several");
  const Linearised at = linearised(scheme, equations, equations.joint_forces(line.omega, motion, false), motion);
  MatrixXcd next(at.motion.rows(), at.motion.cols());
  for (Index n = 0; n < next.rows(); ++n) {
    const HarmonicLine::One& one = line.harmonics[static_cast<std::size_t>(n)];
    const VectorXcd rest =
        (at.force.row(n).array() - at.stiffness.row(n).array() * at.motion.row(n).array()).matrix().transpose();
    const VectorXcd right = level * one.driven - one.joints * rest;
    next.row(n) = (scheme == Scheme::direct ? right : VectorXcd(dense::solve(system_of(at, line, n), right))).transpose();
  }
  return equations.pack(next);
}

Iteration iterate(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line, double level, VectorXd start,
                  const IterationOptions& options) {
  const auto map = [&](const VectorXd& motion) { return stepped(scheme, equations, line, level, motion); };
  Iteration run;
  run.motion = std::move(start);
  VectorXd next = map(run.motion);
  double distance = (next - run.motion).norm();
  for (;; ++run.steps) {
    run.distance = distance / run.motion.norm();
    if (distance <= options.tolerance * run.motion.norm()) run.state = IterationState::converged;
    if (run.state == IterationState::converged || run.steps == options.most_steps) return run;
    if (!next.allFinite()) break;
    VectorXd reached = next, after = map(next);
    double now = (after - reached).norm();
    if (options.search && scheme != Scheme::direct && !(now <= distance)) {
      const VectorXd step = next - run.motion;
      const auto along = [&](double share) {
        const VectorXd motion = run.motion + share * step;
        const double found = (map(motion) - motion).norm();
        return std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
      };
      reached = run.motion + least_between(along, 0.0, 1.0, 1e-6) * step;
      after = map(reached);
      now = (after - reached).norm();
      if (!(now < distance)) break;
      ++run.searches;
    }
    run.motion = std::move(reached);
    next = std::move(after);
    distance = now;
  }
  run.state = IterationState::stalled;
  return run;
}

double convergence_factor(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line, const VectorXd& motion) {
  if (!defined(scheme, equations))
    jointid::refuse("ESD has an equivalent stiffness for one harmonic alone; take LESD for several");
  const Harmonics& harmonics = equations.harmonics();
  const std::vector<ForceHarmonics> forces = equations.joint_forces(line.omega, motion, false);
  const Linearised at = linearised(scheme, equations, forces, motion);
  const Index joints = at.motion.cols(), size = harmonics.unknowns();
  Eigen::MatrixXd real(equations.unknowns(), equations.unknowns());
  // Column by column: the change of F − KQ by one real unknown of one joint, through every harmonic.
  for (Index j = 0; j < joints; ++j) {
    for (Index u = 0; u < size; ++u) {
      VectorXd unit = VectorXd::Zero(size);
      unit(u) = 1.0;
      const VectorXcd moved = harmonics.unpack(unit);
      MatrixXcd change(harmonics.size(), joints);
      for (Index n = 0; n < harmonics.size(); ++n) {
        const Complex rest = forces[static_cast<std::size_t>(j)].by_motion(n, u) - at.stiffness(n, j) * moved(n);
        const VectorXcd right = line.harmonics[static_cast<std::size_t>(n)].joints.col(j) * rest;
        change.row(n) = dense::solve(system_of(at, line, n), right).transpose();
      }
      real.col(j * size + u) = equations.pack(change);
    }
  }
  return dense::eigenvalues(real).cwiseAbs().maxCoeff();
}

}  // namespace jointid::response
