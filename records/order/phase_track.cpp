#include "records/order/phase_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t fewest_crossings = 9;
constexpr double share_of_peak = 1.0 / 3.0;

/// Upward crossings of the mean, s.
std::vector<double> upward_crossings(const std::vector<double>& samples, std::size_t first, double rate_hz) {
  const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
  const auto count = static_cast<double>(samples.end() - begin);
  const double mean = std::accumulate(begin, samples.end(), 0.0) / count;
  double square = 0.0;
  for (auto it = begin; it != samples.end(); ++it) square += (*it - mean) * (*it - mean);
  double peak = std::sqrt(2.0 * square / count), next_peak = 0.0, candidate = 0.0;
  bool is_below = false;
  std::vector<double> crossings;
  for (std::size_t i = first + 1; i < samples.size(); ++i) {
    const double before = samples[i - 1] - mean, now = samples[i] - mean;
    next_peak = std::max(next_peak, std::abs(now));
    if (now < -share_of_peak * peak) is_below = true;
    if (before < 0.0 && now >= 0.0) candidate = (static_cast<double>(i) - now / (now - before)) / rate_hz;
    if (!is_below || now < share_of_peak * peak) continue;
    crossings.push_back(candidate);
    is_below = false;
    if (crossings.size() > 1) peak = next_peak;
    next_peak = 0.0;
  }
  return crossings;
}

}  // namespace

PhaseTrack::PhaseTrack(const Record& record, std::size_t channel, double settle_s) {
  const auto first = static_cast<std::size_t>(std::ceil(settle_s * record.rate_hz));
  if (first + 2 < record.samples()) crossings_ = upward_crossings(record.channels[channel].samples, first, record.rate_hz);
  if (crossings_.size() >= fewest_crossings) return;
  const double length = static_cast<double>(record.samples()) / record.rate_hz;
  throw InputError(
      {ErrorKind::data, record.file, record.channels[channel].name,
       fmt::format(
           "{:.3g} s, of which `settle` leaves out {:.3g} s, have {} upward zero crossings: too few to find the frequency",
           length, settle_s, crossings_.size()),
       "record 8 periods at least, or shorten `settle`; is it the force of a sine?"});
}

double PhaseTrack::mean_hz(std::size_t from, int periods) const {
  return periods / (crossings_[from + static_cast<std::size_t>(periods)] - crossings_[from]);
}

OrderStretch PhaseTrack::fitted(std::size_t from, std::size_t to, bool sweeps) const {
  OrderStretch out;
  out.middle_s = 0.5 * (crossings_[from] + crossings_[to]);
  out.length_s = crossings_[to] - crossings_[from];
  const Eigen::Index terms = sweeps ? 3 : 2;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(terms, terms);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(terms);
  const double half = 0.5 * out.length_s;
  for (std::size_t k = from; k <= to; ++k) {
    const double s = (crossings_[k] - out.middle_s) / half;
    Eigen::VectorXd row(terms);
    for (Eigen::Index p = 0; p < terms; ++p) row(p) = std::pow(s, static_cast<double>(p));
    normal += row * row.transpose();
    right +=
        row * (2.0 * std::numbers::pi * static_cast<double>(k - from) - 0.5 * std::numbers::pi);  // x = cos φ rises through 0
  }
  const Eigen::VectorXd found = dense::solve_positive(normal, Eigen::MatrixXd(right));
  out.phase = found(0);
  out.omega = found(1) / half;
  if (sweeps) out.rate = 2.0 * found(2) / (half * half);
  return out;
}

OrderStretch PhaseTrack::whole() const { return fitted(0, crossings_.size() - 1, false); }

std::optional<OrderStretch> PhaseTrack::about(double hz, int periods) const {
  const auto length = static_cast<std::size_t>(periods);
  if (crossings_.size() <= length) return std::nullopt;
  for (std::size_t from = 0; from + length + 1 < crossings_.size(); ++from) {
    const double now = mean_hz(from, periods) - hz, next = mean_hz(from + 1, periods) - hz;
    if (now * next > 0.0) continue;
    OrderStretch out = fitted(from, from + length, true);
    if (out.rate == 0.0) return std::nullopt;
    const double shift = (angular(hz) - out.omega) / out.rate;
    if (std::abs(shift) > 0.25 * out.length_s) return std::nullopt;
    out.phase += shift * (out.omega + 0.5 * out.rate * shift);
    out.middle_s += shift;
    out.omega = angular(hz);
    out.length_s = periods / hz;
    const bool inside =
        out.middle_s - 0.5 * out.length_s >= crossings_.front() && out.middle_s + 0.5 * out.length_s <= crossings_.back();
    return inside ? std::optional(out) : std::nullopt;
  }
  return std::nullopt;
}

PhaseTrack::Course PhaseTrack::course(int periods) const {
  periods = std::min(periods, static_cast<int>(crossings_.size()) - 1);
  const std::size_t last = crossings_.size() - 1 - static_cast<std::size_t>(periods);
  Course out = {mean_hz(0, periods), mean_hz(last, periods), mean_hz(0, periods), mean_hz(0, periods)};
  for (std::size_t from = 0; from <= last; ++from) {
    out.lowest_hz = std::min(out.lowest_hz, mean_hz(from, periods));
    out.highest_hz = std::max(out.highest_hz, mean_hz(from, periods));
  }
  return out;
}

}  // namespace jointid::records
