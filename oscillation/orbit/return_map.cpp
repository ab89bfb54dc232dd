#include "oscillation/orbit/return_map.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "oscillation/tangent/periodic_point.hpp"
#include "oscillation/tangent/spectrum.hpp"

namespace jointid::oscillation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// The section {V_r = 0, φ·z = σμ_S N} among the free coordinates: z = base + P(z − base).
struct Section {
  Section(const ContactSystem& system, const VectorXd& start) {
    const Index motion = 2 * system.degrees();
    const Mode slip = system.stick_force.dot(start) >= 0.0 ? Mode::forward : Mode::backward;
    gradient = system.stick_force - sign(slip) * system.statical(slip) * system.normal;
    MatrixXd normals(motion, 2);
    normals << system.relative[1].head(motion), gradient.head(motion);
    oscillation::orthonormalise(normals);
    projector = MatrixXd::Identity(motion, motion) - normals * normals.transpose();
    // The point of the section nearest to the start.
    forms.resize(system.size(), 2);
    forms << system.relative[1], gradient;
    base = start;
    for (int pass = 0; pass < 3; ++pass) {
      for (Index k = 0; k < 2; ++k) {
        VectorXd direction = forms.col(k).head(motion);
        if (k == 1) direction -= normals.col(0) * normals.col(0).dot(direction);
        base.head(motion) -= direction * (forms.col(k).dot(base) / forms.col(k).head(motion).dot(direction));
      }
    }
  }
  MatrixXd projector, forms;
  VectorXd gradient, base;
};

MatrixXd unit_tangents(const ContactSystem& system, const std::vector<Index>& free) {
  MatrixXd out = MatrixXd::Zero(system.size(), at(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) out(free[k], at(k)) = 1.0;
  return out;
}

MatrixXd rows(const MatrixXd& a, const std::vector<Index>& places) { return a(places, Eigen::all); }

PeriodicOrbit orbit_of(const oscillation::PeriodicPoint& point) {
  PeriodicOrbit out;
  out.converged = point.converged;
  out.residual = point.residual;
  out.multipliers = point.multipliers;
  return out;
}

constexpr std::size_t most_steps_of_orbits = 300'000, most_steps_of_exponents = 1'000'000;

bool has_arrived(MotionEnd status) { return status == MotionEnd::ok || status == MotionEnd::grazing; }

}  // namespace

PeriodicOrbit break_away_orbit(const ContactSystem& system, const VectorXd& start, std::size_t slips, double longest,
                               const std::function<bool()>& interrupted) {
  if (!system.is_rigid()) throw InputError({ErrorKind::usage, "", "contact", "is compliant: take driven_orbit()", ""});
  const Section section(system, start);
  const std::vector<Index> free = system.free(Mode::stick);
  const Index motion = 2 * system.degrees();
  double period = 0.0;
  const auto placed = [&](const VectorXd& x) {
    VectorXd z = section.base;
    z.head(motion) += section.projector * (x - section.base.head(motion));
    return z;
  };
  const oscillation::TangentStep map = [&](VectorXd& x, MatrixXd& tangents) {
    StickSlip orbit(system, placed(x), Mode::stick);
    orbit.interrupted = interrupted;
    orbit.most_steps = most_steps_of_orbits;
    orbit.break_away();
    orbit.tangents() = unit_tangents(system, free);
    const MotionEnd status = orbit.advance_break_aways(slips, longest);
    period = orbit.time();
    const VectorXd field = system.field(orbit.mode(), orbit.state());
    const bool returned = has_arrived(status) && period < longest;
    x = orbit.state().head(motion);
    if (!returned) x.setConstant(nan);
    const MatrixXd derivative = orbit.tangents() + field * orbit.last_shift();
    tangents = rows(derivative, free) * section.projector * tangents;
  };
  const oscillation::PeriodicPoint point = oscillation::periodic_point(map, section.base.head(motion));
  PeriodicOrbit out = orbit_of(point);
  out.state = placed(point.state);
  VectorXd x = point.state;
  MatrixXd none = MatrixXd::Identity(motion, motion);
  map(x, none);
  out.period = period;
  StickSlip begin(system, out.state, Mode::stick);
  begin.break_away();
  out.mode = begin.mode();
  return out;
}

PeriodicOrbit driven_orbit(const ContactSystem& system, const VectorXd& start, Mode mode, double cycle, std::size_t cycles,
                           const std::function<bool()>& interrupted) {
  const std::vector<Index> free = system.free(mode);
  const auto placed = [&](const VectorXd& x) {
    VectorXd z = system.state(x.head(system.degrees()), x.segment(system.degrees(), system.degrees()));
    for (std::size_t k = 0; k < free.size(); ++k) z(free[k]) = x(at(k));
    return z;
  };
  const oscillation::TangentStep map = [&](VectorXd& x, MatrixXd& tangents) {
    StickSlip orbit(system, placed(x), mode);
    orbit.interrupted = interrupted;
    orbit.most_steps = most_steps_of_orbits;
    orbit.tangents() = unit_tangents(system, free);
    const MotionEnd status = orbit.advance(cycle * static_cast<double>(cycles));
    x = orbit.state()(free);
    if (!has_arrived(status)) x.setConstant(nan);
    tangents = rows(orbit.tangents(), free) * tangents;
  };
  const oscillation::PeriodicPoint point = oscillation::periodic_point(map, start(free));
  PeriodicOrbit out = orbit_of(point);
  out.state = placed(point.state);
  out.mode = mode;
  out.period = cycle * static_cast<double>(cycles);
  return out;
}

Exponents lyapunov_exponents(const ContactSystem& system, const VectorXd& start, const ExponentOptions& options) {
  if (!(options.interval > 0.0) || !(options.length > 0.0) || options.transient < 0.0) {
    throw InputError({ErrorKind::usage, "", "interval, length, transient", "are not above 0", ""});
  }
  StickSlip motion(system, start);
  motion.interrupted = options.interrupted;
  motion.most_steps = most_steps_of_exponents;
  Exponents out;
  const oscillation::TangentStep step = [&](VectorXd& z, MatrixXd& tangents) {
    motion.tangents().swap(tangents);
    const MotionEnd status = motion.advance(motion.time() + options.interval);
    if (status != MotionEnd::ok) out.status = status;
    motion.tangents().swap(tangents);
    z = motion.state();
  };
  const auto count = [&](double time) { return static_cast<std::size_t>(std::llround(time / options.interval)); };
  const oscillation::Spectrum found = oscillation::lyapunov_spectrum(
      step, start, {options.count, count(options.transient), count(options.length), 20, options.interval},
      system.free(Mode::forward));
  out.exponent = found.exponent;
  out.standard_error = found.standard_error;
  return out;
}

}  // namespace jointid::oscillation
