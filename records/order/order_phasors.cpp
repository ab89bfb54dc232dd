#include "records/order/order_phasors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "records/order/order_fit.hpp"
#include "records/order/phase_track.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void fail(const Record& record, std::string place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, record.file, std::move(place), std::move(problem), std::move(remedy)});
}

std::string place_of(const Channel& channel) { return "channel " + channel.name + " (" + channel.dof.name() + ")"; }

/// What part of the samples equal the largest or the smallest one, the larger of both.
double share_at_ends(const std::vector<double>& sorted) {
  const auto lowest = std::ranges::upper_bound(sorted, sorted.front()) - sorted.begin();
  const auto highest = sorted.end() - std::ranges::lower_bound(sorted, sorted.back());
  return static_cast<double>(std::max(lowest, highest)) / static_cast<double>(sorted.size());
}

/// The smallest difference of two samples in parts of their range.
double resolution(const std::vector<double>& sorted) {
  const double range = sorted.back() - sorted.front();
  double least = range;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    if (step > 1e-9 * range) least = std::min(least, step);
  }
  return least / range;
}

void require_sound(const Record& record, const Channel& channel) {
  const auto missing = std::ranges::find_if(channel.samples, [](double x) { return !std::isfinite(x); });
  if (missing != channel.samples.end())
    fail(record, place_of(channel), fmt::format("sample {} is missing", missing - channel.samples.begin() + 1),
         "cut the record before or after it");
  std::vector<double> sorted = channel.samples;
  std::ranges::sort(sorted);
  if (sorted.empty() || sorted.front() == sorted.back())
    fail(record, place_of(channel),
         fmt::format("all samples are {:.4g}: it measured nothing", sorted.empty() ? 0.0 : sorted.front()),
         "is the sensor connected, and is this its channel?");
  const double share = share_at_ends(sorted), of_a_sine = std::sqrt(2.0 * resolution(sorted));
  if (share > 0.005 + 2.0 * of_a_sine)
    fail(record, place_of(channel),
         fmt::format("{:.2g} % of its samples equal the end of its range, {:.4g}: it is clipped", 100.0 * share, sorted.back()),
         "choose a wider range, or leave the channel out");
}

/// Smallest allowed share of the force's variance that is orders of its own frequency.
constexpr double least_explained = 0.5;

void require_sine(const Record& record, std::size_t force, const OrderFit& fit, double hz) {
  const double explained = fit.explained(jointid::at(force));
  if (explained >= least_explained) return;
  fail(record, place_of(record.channels[force]),
       fmt::format("only {:.2g} % of its variance are {:.6g} Hz and its orders: the force is no steady sine there",
                   100.0 * explained, hz),
       "is it the force's channel? Steady records have one frequency each; `sweep = true` reads a slow sweep");
}

void require_steady(const Record& record, const OrderFit& fit) {
  constexpr double most_change = 0.05, most_deviations = 5.0;
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const Eigen::Index column = jointid::at(c);
    // In the direction of X₁: its amplitude. A turning phase is the frequency's.
    const double size = std::abs(fit.value(0, column));
    const double change = 2.0 * (fit.slope(0, column) * std::conj(fit.value(0, column))).real() / size;
    const double deviation = 2.0 * fit.slope_deviation * fit.deviation(0, column);
    if (std::abs(change) < most_change * size || std::abs(change) < most_deviations * deviation) continue;
    fail(record, place_of(record.channels[c]),
         fmt::format("there is no steady state: its amplitude of {:.4g} changes by {:+.2g} % from end to end", size,
                     100.0 * change / size),
         "leave out the unsteady beginning by `settle` (s), or record longer");
  }
}

double larger_by_freedom(double deviation, double freedom) {
  return deviation * std::sqrt(freedom > 2.0 ? freedom / (freedom - 2.0) : 3.0);
}

OrderPhasors phasors_of(const OrderStretch& stretch, const OrderFit& fit) {
  OrderPhasors out;
  out.frequency_hz = hertz(stretch.omega);
  out.periods = stretch.periods();
  out.value = fit.value;
  out.deviation = fit.deviation.binaryExpr(
      fit.freedom, [](double deviation, double freedom) { return larger_by_freedom(deviation, freedom); });
  return out;
}

/// The force alone.
Record only(const Record& record, std::size_t channel) {
  return {.file = record.file, .rate_hz = record.rate_hz, .channels = {record.channels[channel]}};
}

constexpr int most_rounds = 6;
constexpr double settled_turn = 1e-9;  ///< rad over the stretch

/// By how much the force's phase turns from the stretch's own in a second, rad/s.
double turn_of(const Record& force, const OrderStretch& stretch, const std::vector<int>& harmonics, int degree) {
  const OrderFit fit = fit_orders(force, stretch, harmonics, degree, NoiseOfOrders::left_out);
  return (fit.slope(0, 0) / fit.value(0, 0)).imag() * 2.0 / stretch.length_s;
}

/// The stretch with the frequency at which the force's own phase does not turn any more.
OrderStretch steadied(const Record& force, OrderStretch stretch, const std::vector<int>& harmonics) {
  for (int round = 0; round < most_rounds; ++round) {
    const double turn = turn_of(force, stretch, harmonics, 1);
    stretch.omega += turn;
    if (std::abs(turn) * stretch.length_s < settled_turn) break;
  }
  return stretch;
}

/// The stretch about the moment at which the force's instantaneous frequency is that of the line.
OrderStretch centred(const Record& force, OrderStretch stretch, const std::vector<int>& harmonics) {
  for (int round = 0; round < most_rounds; ++round) {
    const double turn = turn_of(force, stretch, harmonics, 2), shift = -turn / stretch.rate;
    stretch.middle_s += shift;
    stretch.phase += shift * (stretch.omega + turn);
    if (std::abs(turn) * stretch.length_s < settled_turn) break;
  }
  return stretch;
}

double largest_ratio(const Record& record, const Eigen::RowVectorXcd& change, const Eigen::RowVectorXcd& of) {
  double largest = 0.0;
  for (const std::size_t c : motion_channels(record))
    largest = std::max(largest, std::abs(change(jointid::at(c)) / of(jointid::at(c))));
  return largest;
}

void require_one_sweep(const Record& record, std::size_t force, const PhaseTrack::Course& course) {
  const double span = std::abs(course.last_hz - course.first_hz), all = course.highest_hz - course.lowest_hz;
  if (!(all > 1e-3 * course.highest_hz))
    fail(record, place_of(record.channels[force]),
         fmt::format("its frequency stays at {:.6g} Hz: it does not sweep", course.first_hz),
         "leave out sweep for steady records");
  if (span < 0.8 * all)
    fail(record, place_of(record.channels[force]),
         fmt::format("its frequency goes from {:.5g} to {:.5g} Hz by way of {:.5g} and {:.5g} Hz: it sweeps more than once",
                     course.first_hz, course.last_hz, course.lowest_hz, course.highest_hz),
         "cut the record into one file for each sweep up or down, which are force levels of their own");
}

}  // namespace

void require_sound(const Record& record) {
  for (const Channel& channel : record.channels) require_sound(record, channel);
}

OrderPhasors steady_phasors(const Record& record, const OrderOptions& options) {
  require_sound(record);
  const std::size_t force = force_channels(record).front();
  const PhaseTrack track(record, force, options.settle_s);
  const OrderStretch stretch = steadied(only(record, force), track.whole(), options.harmonics);
  const double hz = hertz(stretch.omega);
  constexpr double most_off = 1e-3;
  const OrderFit moving = fit_orders(record, stretch, options.harmonics, 1);
  require_sine(record, force, moving, hz);
  if (options.frequency_hz && std::abs(hz / *options.frequency_hz - 1.0) > most_off)
    fail(record, place_of(record.channels[force]),
         fmt::format("its frequency is {:.7g} Hz, not {:.7g} Hz", hz, *options.frequency_hz),
         "correct `lines`, or the rate of the record");
  require_steady(record, moving);
  return phasors_of(stretch, fit_orders(record, stretch, options.harmonics, 0));
}

std::vector<OrderPhasors> sweep_phasors(const Record& record, const std::vector<double>& lines_hz, const OrderOptions& options) {
  require_sound(record);
  const std::size_t force = force_channels(record).front();
  const PhaseTrack track(record, force, options.settle_s);
  require_one_sweep(record, force, track.course(options.periods));
  const Record force_alone = only(record, force);
  std::vector<OrderPhasors> all;
  for (const double hz : lines_hz) {
    auto stretch = track.about(hz, options.periods);
    if (!stretch) continue;
    *stretch = centred(force_alone, *stretch, options.harmonics);
    const OrderFit fit = fit_orders(record, *stretch, options.harmonics, 2);
    require_sine(record, force, fit, hz);
    OrderStretch half = *stretch;
    half.length_s *= 0.5;
    OrderPhasors phasors = phasors_of(*stretch, fit);
    const double half_s = 0.5 * stretch->length_s;
    phasors.lag_bias = largest_ratio(record, fit.bend.row(0) / (half_s * half_s * stretch->rate), fit.value.row(0));
    if (half.periods() >= 8.0)
      phasors.window_bias = largest_ratio(
          record, fit_orders(record, half, options.harmonics, 2, NoiseOfOrders::left_out).value.row(0) - fit.value.row(0),
          fit.value.row(0));
    all.push_back(std::move(phasors));
  }
  return all;
}

}  // namespace jointid::records
