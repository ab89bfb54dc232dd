#include "oscillation/integrate/stick_slip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/control.hpp"
#include "oscillation/integrate/first_root.hpp"

namespace jointid::oscillation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// The first root of coefficients of which the first `zeros` are 0 by analysis.
std::optional<double> root_of(const VectorXd& c, double length, int zeros) {
  return first_root({c.data() + zeros, static_cast<std::size_t>(c.size() - zeros)}, length);
}

}  // namespace

const char* word(MotionEnd status) {
  switch (status) {
    case MotionEnd::ok:
      return "ok";
    case MotionEnd::stalled:
      return "stalled";
    case MotionEnd::grazing:
      return "grazing";
    case MotionEnd::diverged:
      return "diverged";
    case MotionEnd::too_long:
      return "too_long";
  }
  return "";
}

StickSlip::StickSlip(const ContactSystem& system, VectorXd start, std::optional<Mode> mode, double time)
    : system_(system), series_(system), state_(std::move(start)), tangents_(state_.size(), 0), time_(time) {
  if (mode) {
    mode_ = before_ = *mode;
    return;
  }
  const double v = system.relative[place(Mode::stick)].dot(state_);
  if (v != 0.0) {
    mode_ = v > 0.0 ? Mode::forward : Mode::backward;
  } else if (const double f = system.stick_force.dot(state_);
             system.holds(f, system.normal.dot(state_))) {
    mode_ = Mode::stick;
  } else {
    mode_ = f > 0.0 ? Mode::forward : Mode::backward;
    zeros_ = 1;
  }
  before_ = mode_;
}

int StickSlip::break_away_zeros() const {
  if (!system_.is_rigid()) return 0;
  return system_.is_falling() || system_.friction.statical == system_.friction.kinetic ? 2 : 1;
}

void StickSlip::break_away() {
  before_ = Mode::stick;
  mode_ = system_.stick_force.dot(state_) >= 0.0 ? Mode::forward : Mode::backward;
  state_ = system_.on_slip * state_;
  zeros_ = break_away_zeros();
}

std::optional<StickSlip::Found> StickSlip::slip_end(const Piece& piece) const {
  const VectorXd& r = system_.relative[place(mode_)];
  const auto tau = root_of(sign(mode_) * piece.along(r), piece.length, zeros_);
  if (!tau) return std::nullopt;
  if (!system_.is_rigid()) return Found{*tau, r, Mode::stick, system_.on_stick[place(mode_)]};
  const VectorXd z = piece.at(*tau);
  const double f = system_.stick_force.dot(z);
  if (system_.holds(f, system_.normal.dot(z)))
    return Found{*tau, r, Mode::stick, system_.on_stick[place(mode_)]};
  return Found{*tau, r, f > 0.0 ? Mode::forward : Mode::backward, {}};
}

std::optional<StickSlip::Found> StickSlip::stick_end(const Piece& piece) const {
  std::optional<Found> first;
  const VectorXd load = piece.along(system_.normal), force = piece.along(system_.stick_force);
  for (const Mode slip : {Mode::forward, Mode::backward}) {
    const auto tau = root_of(system_.statical(slip) * load - sign(slip) * force, piece.length, slip == before_ ? zeros_ : 0);
    if (!tau || (first && *tau >= first->tau)) continue;
    first = Found{*tau, system_.statical(slip) * system_.normal - sign(slip) * system_.stick_force, slip, system_.on_slip};
  }
  return first;
}

std::optional<StickSlip::Found> StickSlip::next_event(const Piece& piece) const {
  return mode_ == Mode::stick ? stick_end(piece) : slip_end(piece);
}

void StickSlip::take(const Found& found) {
  const MatrixXd change = found.change.size() > 0 ? found.change : MatrixXd::Identity(state_.size(), state_.size());
  const VectorXd before = state_;
  state_ = change * before;
  if (tangents_.cols() > 0) {
    const VectorXd field = system_.field(mode_, before);
    const double speed = found.gradient.dot(field);
    grazed_ = grazed_ || std::abs(speed) <= 1e-13 * found.gradient.norm() * field.norm();
    shift_ = -(found.gradient.transpose() * tangents_) / speed;
    const bool smooth = mode_ == Mode::stick && system_.is_rigid() && break_away_zeros() == 2;
    if (!smooth) tangents_ = (change * tangents_ - (system_.field(found.to, state_) - change * field) * shift_).eval();
  }
  const Event event{time_, mode_, found.to, state_, system_.force(found.to, state_)};
  zeros_ = 0;
  if (mode_ == Mode::stick) {
    zeros_ = break_away_zeros();
  } else if (found.to != Mode::stick) {
    zeros_ = 1;
  } else if (!system_.is_rigid() && system_.friction.statical == system_.friction.kinetic) {
    zeros_ = 2;
  }
  before_ = mode_;
  mode_ = found.to;
  if (on_event && event.from != event.to) on_event(event);
}

/// Whether the steps taken since `begin` lead far beyond most_steps before `until`.
bool StickSlip::is_hopeless(double begin, double until) const {
  constexpr double surely = 1000.0;
  return !((until - begin) * static_cast<double>(looked_at) <= surely * static_cast<double>(most_steps) * (time_ - begin));
}

MotionEnd StickSlip::run(double until, std::size_t break_aways) {
  const double begin = time_;
  std::size_t taken = 0;
  while (time_ < until) {
    stop_if(interrupted);
    if (++steps_ > most_steps || (break_aways == 0 && ++taken == looked_at && is_hopeless(begin, until))) return MotionEnd::too_long;
    series_.expand(mode_, state_, piece_);
    if (!std::isfinite(piece_.coefficients.rightCols(1).sum())) return MotionEnd::diverged;
    piece_.start = time_;
    piece_.length = std::min(piece_.length, until - time_);
    const bool last = time_ + piece_.length >= until;
    const auto found = next_event(piece_);
    if (found) piece_.length = found->tau;
    if (on_piece && piece_.length > 0.0) on_piece(piece_);
    state_ = piece_.at(piece_.length);
    if (tangents_.cols() > 0) {
      series_.expand_tangents(tangents_, tangent_series_);
      tangents_ = tangents_at(tangent_series_, piece_.length);
    }
    const double now = !found && last ? until : time_ + piece_.length;
    idle_ = now > time_ ? 0 : idle_ + 1;
    time_ = now;
    if (idle_ > 100) return MotionEnd::stalled;
    if (!found) {
      zeros_ = 0;
      continue;
    }
    const bool breaks = mode_ == Mode::stick;
    take(*found);
    if (breaks && break_aways > 0 && --break_aways == 0) break;
  }
  return grazed_ ? MotionEnd::grazing : MotionEnd::ok;
}

MotionEnd StickSlip::advance(double until) { return run(until, 0); }
MotionEnd StickSlip::advance_break_aways(std::size_t count, double until) { return count == 0 ? MotionEnd::ok : run(until, count); }

Motion integrate(const ContactSystem& system, const VectorXd& start, double until, const std::vector<double>& times,
                 const std::function<bool()>& interrupted) {
  StickSlip motion(system, start);
  motion.interrupted = interrupted;
  Motion out;
  out.samples.resize(start.size(), at(times.size()));
  std::size_t next = 0;
  motion.on_event = [&](const Event& event) { out.events.push_back(event); };
  motion.on_piece = [&](const Piece& piece) {
    for (; next < times.size() && times[next] <= piece.start + piece.length; ++next) {
      out.samples.col(at(next)) = piece.at(times[next] - piece.start);
    }
  };
  out.status = motion.advance(until);
  out.end = motion.state();
  for (; next < times.size(); ++next) out.samples.col(at(next)) = out.end;
  return out;
}

std::vector<double> equal_times(double step, std::size_t count) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(step * static_cast<double>(i));
  return times;
}

}  // namespace jointid::oscillation
