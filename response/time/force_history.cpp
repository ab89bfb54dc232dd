#include "response/time/force_history.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::data, .file = {}, .place = "force", .problem = problem, .remedy = remedy});
}

}  // namespace

ForceHistory ForceHistory::periodic(double omega, const std::vector<int>& harmonics, const Eigen::MatrixXcd& amplitudes,
                                    double until) {
  if (!(omega > 0.0) || !std::isfinite(omega)) refuse("frequency " + std::to_string(omega) + " rad/s", "give one above 0");
  if (at(harmonics.size()) != amplitudes.cols()) {
    refuse(std::to_string(amplitudes.cols()) + " columns of amplitudes", "give one for each harmonic");
  }
  if (!amplitudes.allFinite()) refuse("an amplitude is not finite", "give finite numbers");
  if (std::ranges::any_of(harmonics, [](int n) { return n < 0; })) refuse("a harmonic below 0", "give 0, 1, 2 …");
  ForceHistory force;
  const Index count = amplitudes.cols();
  force.load_.resize(amplitudes.rows(), 2 * count);
  VectorXd start(2 * count);
  for (Index h = 0; h < count; ++h) {
    force.frequencies_.push_back(omega * harmonics[static_cast<std::size_t>(h)]);
    force.load_.col(2 * h) = amplitudes.col(h).real();
    force.load_.col(2 * h + 1) = -amplitudes.col(h).imag();
    start.segment(2 * h, 2) << 1.0, 0.0;
  }
  force.pieces_.push_back({0.0, start});
  if (std::isfinite(until)) force.pieces_.push_back({until, VectorXd::Zero(2 * count)});
  return force;
}

ForceHistory ForceHistory::half_sine(const VectorXd& peak, double duration) {
  if (!(duration > 0.0)) refuse("duration " + std::to_string(duration) + " s", "give one above 0");
  return periodic(std::numbers::pi / duration, {1}, Complex(0.0, -1.0) * peak, duration);
}

ForceHistory ForceHistory::sampled(const MatrixXd& directions, const std::vector<double>& times, const MatrixXd& values) {
  const Index lines = directions.cols();
  if (times.size() < 2) refuse(std::to_string(times.size()) + " samples", "give two or more");
  if (at(times.size()) != values.rows() || values.cols() != lines) {
    refuse("values are " + std::to_string(values.rows()) + " × " + std::to_string(values.cols()),
           "give a row for each time and a column for each direction");
  }
  if (!values.allFinite() || !directions.allFinite()) refuse("a value is not finite", "give finite numbers");
  if (!(times.front() >= 0.0)) refuse("the first time is " + std::to_string(times.front()) + " s", "begin at 0 or later");
  ForceHistory force;
  force.load_ = MatrixXd::Zero(directions.rows(), 2 * lines);
  for (Index l = 0; l < lines; ++l) force.load_.col(2 * l) = directions.col(l);
  if (times.front() > 0.0) force.pieces_.push_back({0.0, VectorXd::Zero(2 * lines)});
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double width = times[i + 1] - times[i];
    if (!(width > 0.0))
      refuse("times do not increase at " + std::to_string(times[i + 1]) + " s", "sort them and leave out repeats");
    VectorXd state(2 * lines);
    for (Index l = 0; l < lines; ++l) {
      state.segment(2 * l, 2) << values(at(i), l), (values(at(i + 1), l) - values(at(i), l)) / width;
    }
    force.pieces_.push_back({times[i], state});
  }
  force.pieces_.push_back({times.back(), VectorXd::Zero(2 * lines)});
  return force;
}

VectorXd ForceHistory::state(double time) const {
  const auto after = std::ranges::upper_bound(pieces_, time, {}, &Piece::start);
  if (after == pieces_.begin()) return VectorXd::Zero(load_.cols());
  const Piece& piece = *(after - 1);
  VectorXd state = piece.state;
  const double passed = time - piece.start;
  const Index harmonics = at(frequencies_.size());
  for (Index h = 0; h < harmonics; ++h) {
    const double angle = frequencies_[static_cast<std::size_t>(h)] * passed, c = std::cos(angle), s = std::sin(angle);
    const double cosine = state[2 * h], sine = state[2 * h + 1];
    state[2 * h] = c * cosine - s * sine;
    state[2 * h + 1] = s * cosine + c * sine;
  }
  for (Index i = 2 * harmonics; i + 1 < state.size(); i += 2) state[i] += passed * state[i + 1];
  return state;
}

MatrixXd ForceHistory::generator() const {
  MatrixXd generator = MatrixXd::Zero(load_.cols(), load_.cols());
  const Index harmonics = at(frequencies_.size());
  for (Index h = 0; h < harmonics; ++h) {
    const double frequency = frequencies_[static_cast<std::size_t>(h)];
    generator(2 * h, 2 * h + 1) = -frequency;
    generator(2 * h + 1, 2 * h) = frequency;
  }
  for (Index i = 2 * harmonics; i + 1 < generator.rows(); i += 2) generator(i, i + 1) = 1.0;
  return generator;
}

double ForceHistory::next_change(double time) const {
  const auto after = std::ranges::upper_bound(pieces_, time, {}, &Piece::start);
  return after == pieces_.end() ? std::numeric_limits<double>::infinity() : after->start;
}

double ForceHistory::highest_frequency() const { return frequencies_.empty() ? 0.0 : std::ranges::max(frequencies_); }

}  // namespace jointid::response
