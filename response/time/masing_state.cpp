#include "response/time/masing_state.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {

using friction::Response;

MasingState::MasingState(const friction::Element& law) : path_(law), kinks_(law.kinks()) { choose_piece(1); }

/// The argument of T on the present branch; below 0 before its corner.
double MasingState::piece_argument(double q) const {
  return branch_.initial ? direction_ * q : 0.5 * direction_ * (q - branch_.corner.displacement);
}

Response MasingState::response(double q) const {
  const double v = piece_argument(q);
  const Response law = path_.element().response(std::abs(v));
  const double force = std::copysign(law.force, v) * direction_;
  if (branch_.initial) return {force, law.tangent};
  return {branch_.corner.force + 2.0 * force, law.tangent};
}

MasingState::Row MasingState::drift(double q) const {
  if (branch_.initial || slopes_.empty() || slopes_.back().force.size() != parameters_) return Row::Zero(parameters_);
  const double tangent = piece_.stiffness.value_or(response(q).tangent);
  return slopes_.back().force - tangent * slopes_.back().displacement;
}

/// T is concave: a tangent that is the same at both ends of a piece is constant on it.
void MasingState::choose_piece(int direction) {
  direction_ = direction;
  branch_ = path_.branch(direction);
  const double v = std::max(piece_argument(path_.displacement()), 0.0);
  const auto next = std::ranges::find_if(kinks_, [&](double kink) { return kink > v * (1.0 + 1e-12); });
  const double begin = next == kinks_.begin() ? 0.0 : *(next - 1), end = next == kinks_.end() ? friction::infinity : *next;
  const double per_argument = branch_.initial ? direction : 2.0 * direction;
  const double kink = (branch_.initial ? 0.0 : branch_.corner.displacement) + per_argument * end;
  const double bound = direction > 0 ? std::min(kink, branch_.closure) : std::max(kink, branch_.closure);
  piece_ = {direction, direction > 0 ? -friction::infinity : bound, direction > 0 ? bound : friction::infinity, {}};
  const double far = std::isfinite(end) ? begin + (end - begin) * (1.0 - 1e-12) : 1e6 * std::max({begin, v, 1.0});
  const double tangent = path_.element().response(begin).tangent;
  if (tangent == path_.element().response(far).tangent) piece_.stiffness = tangent;
  if (kinks_.empty() && piece_.stiffness) piece_ = {0, -friction::infinity, friction::infinity, tangent};  // a spring
}

void MasingState::pass(double q) {
  path_.advance(q);
  slopes_.resize(path_.corners().size(), {Row::Zero(parameters_), Row::Zero(parameters_)});
}

void MasingState::begin(double q, int direction, double) {
  if (q != path_.displacement()) pass(q);
  if (piece_.direction != 0 && path_.direction() != 0 && direction == -path_.direction()) {
    const Row none = Row::Zero(parameters_);
    Row force = none;
    direction_ = path_.direction();
    turn(q, none, force);
    return;
  }
  choose_piece(direction);
}

double MasingState::turn(double q, const Row& dq, Row& df) {
  const int direction = -direction_;
  if (q != path_.displacement()) pass(q);
  if (path_.direction() == 0) {
    choose_piece(direction);  // It had not moved yet.
    return path_.force();
  }
  slopes_.push_back({dq, df});
  turns_.push_back({q, dq});
  choose_piece(direction);
  return path_.force();
}

double MasingState::reach(double q, const Row& dq, Row& df) {
  pass(q);
  choose_piece(direction_);
  df = first_slope(q, dq, df);
  return path_.force();
}

void MasingState::remember(const std::vector<Turn>& turns, double q, std::optional<double> inside) {
  path_ = friction::MasingPath(path_.element());
  slopes_.clear();
  for (const Turn& turn : turns) {
    const Response at = path_.advance(turn.displacement);
    slopes_.resize(path_.corners().size(), {Row::Zero(parameters_), Row::Zero(parameters_)});
    Row force = inside.value_or(at.tangent) * turn.slope;
    if (!slopes_.empty()) force = slopes_.back().force + at.tangent * (turn.slope - slopes_.back().displacement);
    slopes_.push_back({turn.slope, force});
  }
  pass(q);
  choose_piece(path_.direction() < 0 ? -1 : 1);
}

void MasingState::follow(Eigen::Index parameters) {
  if (parameters == parameters_) return;
  parameters_ = parameters;
  for (CornerSlope& slope : slopes_) slope = {Row::Zero(parameters), Row::Zero(parameters)};
  for (Turn& turn : turns_) turn.slope = Row::Zero(parameters);
}

MasingState::Row MasingState::first_slope(double q, const Row& dq, const Row&) const {
  return piece_.stiffness.value_or(response(q).tangent) * dq + drift(q);
}

bool MasingState::keeps_residual_force(double range) const {
  const friction::Element& law = path_.element();
  if (kinks_.empty()) return law.response(0.5 * range).tangent != law.response(0.0).tangent;  // only a spring has no memory
  return !(0.5 * range >= kinks_.back());
}

}  // namespace jointid::response
