#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "oscillation/integrate/taylor.hpp"

namespace jointid::oscillation {

/// A change of mode, with the state just after it.
struct Event {
  double time = 0.0;
  Mode from = Mode::forward, to = Mode::stick;
  Eigen::VectorXd state;
  double force = 0.0;  ///< on the body, just after
};

/// End of an integration.
enum class MotionEnd {
  ok,
  stalled,   ///< 100 events or steps by which time does not go on: the contact's law has no motion from there, or rounding hides
             ///< it
  grazing,   ///< an event that the orbit only touches: variations have no limit there, the motion has one
  diverged,  ///< numbers that are not finite
  too_long   ///< more than `most_steps` steps, or a thousand times as many by an estimate from the first 4,000
};
const char* word(MotionEnd status);

/// Event-exact integration of a contact system. In each mode the motion is a Taylor series of order 24; events are roots of the
/// step's own polynomial. Sticking begins if V_r = 0 and |φ·z| ≤ μ_S N (rigid; else the contact passes to slipping along φ·z),
/// always if V_r = 0 (compliant). It ends if |φ·z| = μ_S N. Tangents use the same series, and S = R + (F₊ − R F₋)∇hᵀ/(∇hᵀF₋)
/// across events, R the change of the state.
class StickSlip {
 public:
  /// The mode follows from V_r at the start; with V_r = 0 it sticks if friction can hold it. `mode` overrides it.
  StickSlip(const ContactSystem& system, Eigen::VectorXd start, std::optional<Mode> mode = std::nullopt, double time = 0.0);

  /// Called for every part of the motion in one mode and step, cut at the event or end; and for every event.
  std::function<void(const Piece&)> on_piece;
  std::function<void(const Event&)> on_event;
  /// Asked before every step: true ends the integration with Interrupted.
  std::function<bool()> interrupted;

  /// Of the series, all together; a step is about a period of the fastest motion, at most.
  std::size_t most_steps = 3'000'000;

  /// Continues to time `until`.
  MotionEnd advance(double until);
  /// Continues until `count` further sticks have ended, or to time `until`.
  MotionEnd advance_break_aways(std::size_t count, double until);

  double time() const { return time_; }
  Mode mode() const { return mode_; }
  const Eigen::VectorXd& state() const { return state_; }
  Eigen::MatrixXd& tangents() { return tangents_; }  ///< [size, any]; none at first
  /// Delay of the last event for each tangent.
  const Eigen::RowVectorXd& last_shift() const { return shift_; }
  /// Starts slipping from the limit of a stick, as after a break-away.
  void break_away();

 private:
  static constexpr std::size_t looked_at = 4000;

  struct Found {
    double tau = 0.0;
    Eigen::VectorXd gradient;  ///< ∇h
    Mode to = Mode::stick;
    Eigen::MatrixXd change;  ///< R; empty: the identity
  };

  std::optional<Found> next_event(const Piece& piece) const;
  std::optional<Found> slip_end(const Piece& piece) const;
  std::optional<Found> stick_end(const Piece& piece) const;
  void take(const Found& found);
  MotionEnd run(double until, std::size_t break_aways);
  bool is_hopeless(double begin, double until) const;
  int break_away_zeros() const;

  const ContactSystem& system_;
  TaylorSeries series_;
  Eigen::VectorXd state_;
  Eigen::MatrixXd tangents_;
  Eigen::RowVectorXd shift_;
  Mode mode_ = Mode::forward, before_ = Mode::forward;
  double time_ = 0.0;
  int zeros_ = 0;  ///< of the event function at the start of this mode, by analysis: they are divided out in its first step
  std::size_t idle_ = 0, steps_ = 0;
  bool grazed_ = false;
  Piece piece_;
  std::vector<Eigen::MatrixXd> tangent_series_;
};

/// All events up to `until`, and the states at `times` (ascending, from 0 on, up to `until`), a column each.
struct Motion {
  MotionEnd status = MotionEnd::ok;
  std::vector<Event> events;
  Eigen::MatrixXd samples;
  Eigen::VectorXd end;
};
Motion integrate(const ContactSystem& system, const Eigen::VectorXd& start, double until, const std::vector<double>& times = {},
                 const std::function<bool()>& interrupted = {});

/// i·step for i = 0 … count − 1.
std::vector<double> equal_times(double step, std::size_t count);

}  // namespace jointid::oscillation
