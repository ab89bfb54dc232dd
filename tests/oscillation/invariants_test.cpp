#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "oscillation/integrate/stick_slip.hpp"
#include "oscillation/system/thesis_systems.hpp"

namespace jointid::oscillation {
namespace {

double uniform(double low, double high) {
  constexpr int steps = 1 << 20;
  return low + (high - low) * *rc::gen::inRange(0, steps + 1) / steps;
}

Friction friction_between(double most) {
  Friction out{uniform(0.05, most), 0.0, std::nullopt, uniform(0.2, 3.0), 0.0, std::nullopt};
  out.statical = out.kinetic * *rc::gen::element(1.0, 1.0 + 1e-9, 1.2, 2.0);
  out.tilt = *rc::gen::element(0.0, uniform(-0.3, 0.3)) * std::atan(out.kinetic);
  return out;
}

/// Masses in series on a belt or on the ground, the first one perhaps driven.
struct RandomCase {
  Mechanics mechanics;
  Drive drive;
  Friction friction;
  Eigen::VectorXd q, v;
  double until;
};

RandomCase random_case() {
  const auto n = static_cast<Eigen::Index>(*rc::gen::inRange(1, 5));
  BeltChain chain;
  chain.masses = static_cast<std::size_t>(n);
  chain.mass = uniform(0.3, 3.0);
  chain.damping = *rc::gen::element(0.0, 0.01, 0.3);
  RandomCase out{mechanics(chain), {*rc::gen::element(0.0, 0.1, -0.3, 1.0), 0.0, 0.0}, friction_between(1.0), {}, {}, 40.0};
  if (*rc::gen::arbitrary<bool>()) {
    out.drive.angular_frequency = uniform(0.2, 3.0);
    out.drive.amplitude = *rc::gen::element(0.0, 0.5);
    out.mechanics.forcing = uniform(0.0, 2.0) * Eigen::VectorXd::Unit(n, 0);
  }
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      out.friction.decay = uniform(0.2, 8.0);
      break;
    case 1:
      out.friction.contact_stiffness = uniform(0.5, 200.0);
      break;
    default:
      break;
  }
  out.friction.normal_slope = *rc::gen::element(0.0, 0.002 * out.friction.normal, -0.002 * out.friction.normal);
  out.q = Eigen::VectorXd::Zero(n), out.v = out.q;
  for (Eigen::Index i = 0; i < n; ++i) out.q(i) = uniform(-3.0, 3.0), out.v(i) = *rc::gen::element(0.0, uniform(-1.0, 1.0));
  return out;
}

/// Work of friction, damping and forcing make up the change of energy; sticking forces stay within their limit, slips keep their
/// direction, positions and velocities are continuous, velocities follow from positions.
RC_GTEST_PROP(Motion, KeepsItsLaws, ()) {
  const RandomCase each = random_case();
  const ContactSystem system(each.mechanics, each.drive, each.friction);
  const Eigen::Index n = system.degrees();
  StickSlip motion(system, system.state(each.q, each.v));
  double scale = 1.0, worst = 0.0, jump = 0.0, work = 0.0;
  Eigen::VectorXd last = motion.state();
  const auto energy = [&](const Eigen::VectorXd& z) {
    return 0.5 * z.segment(n, n).dot(each.mechanics.mass * z.segment(n, n)) +
           0.5 * z.head(n).dot(each.mechanics.stiffness * z.head(n));
  };
  const auto power = [&](Mode mode, const Eigen::VectorXd& z) {
    const Eigen::VectorXd v = z.segment(n, n);
    double out = system.force(mode, z) * each.mechanics.contact.dot(v) - v.dot(each.mechanics.damping * v);
    if (each.mechanics.forcing.size() > 0) out += each.mechanics.forcing.dot(v) * z(2 * n + 2);
    return out;
  };
  constexpr double nodes[] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
  constexpr double weights[] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};
  motion.on_piece = [&](const Piece& piece) {
    jump = std::max(jump, (piece.at(0.0) - last).head(2 * n).cwiseAbs().maxCoeff());
    for (int part = 0; part < 8; ++part) {
      for (int g = 0; g < 4; ++g) {
        const Eigen::VectorXd z = piece.at(piece.length * (part + nodes[g]) / 8.0);
        work += weights[g] * piece.length / 8.0 * power(piece.mode, z);
        scale = std::max(scale, z.head(2 * n).cwiseAbs().maxCoeff());
        if (piece.mode == Mode::stick) {
          const double force = system.stick_force.dot(z);
          const Mode towards = force >= 0.0 ? Mode::forward : Mode::backward;
          worst = std::max(worst, std::abs(force) - system.statical(towards) * system.normal.dot(z));
          if (system.is_rigid()) worst = std::max(worst, std::abs(system.relative[place(Mode::stick)].dot(z)));
        } else {
          worst = std::max(worst, -sign(piece.mode) * system.relative[place(piece.mode)].dot(z));
        }
      }
    }
    last = piece.at(piece.length);
  };
  const MotionEnd status = motion.advance(each.until);
  RC_ASSERT(status == MotionEnd::ok);
  RC_ASSERT(worst < 1e-10 * scale);
  RC_ASSERT(jump < 1e-12 * scale);
  const double change = energy(motion.state()) - energy(system.state(each.q, each.v));
  RC_ASSERT(std::abs(change - work) < 1e-8 * scale * scale * static_cast<double>(n + 1));
}

/// A motion cut anywhere and started again from there is the same motion.
RC_GTEST_PROP(Motion, GoesOnFromWhereItWasCut, ()) {
  const RandomCase each = random_case();
  const ContactSystem system(each.mechanics, each.drive, each.friction);
  const Eigen::VectorXd start = system.state(each.q, each.v);
  StickSlip whole(system, start), cut(system, start);
  const double at = uniform(0.5, 11.0);
  RC_ASSERT(whole.advance(12.0) == MotionEnd::ok);
  RC_ASSERT(cut.advance(at) == MotionEnd::ok);
  RC_ASSERT(cut.advance(12.0) == MotionEnd::ok);
  const Eigen::Index motion = 2 * system.degrees();
  const double difference = (whole.state() - cut.state()).head(motion).cwiseAbs().maxCoeff();
  RC_ASSERT(difference < 1e-6 * (1.0 + whole.state().head(motion).cwiseAbs().maxCoeff()));
}

}  // namespace
}  // namespace jointid::oscillation
