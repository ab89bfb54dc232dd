#include "records/estimate/blow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t flat_samples = 3;
constexpr double bits_of_slope = 4.0, coarsest_bit = 0.01;  ///< of the largest sample

std::size_t samples_of(double seconds, double rate_hz) { return static_cast<std::size_t>(std::llround(seconds * rate_hz)); }

std::span<const double> stretch(const Channel& channel, const Blow& blow) {
  return std::span(channel.samples).subspan(blow.first, blow.length);
}

/// Index of the largest |x| in [first, end); `first` where all are NaN.
std::size_t largest(std::span<const double> x, std::size_t first, std::size_t end) {
  std::size_t best = first;
  for (std::size_t i = first; i < end; ++i) {
    if (std::abs(x[i]) > std::abs(x[best]) || std::isnan(x[best])) best = i;
  }
  return best;
}

Blow blow_at(const Record& record, std::size_t index, std::size_t first, std::size_t length) {
  const std::vector<double>& force = record.channels[force_channel(record)].samples;
  const std::size_t peak = largest(force, first, first + length);
  return {index, first, length, peak, force[peak]};
}

/// The smallest step between samples: one bit of a converter.
double finest_step(std::span<const double> x) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] != x[i - 1]) step = std::min(step, std::abs(x[i] - x[i - 1]));
  }
  return step;
}

/// A flat top that the signal enters or leaves by more than a few bits: the round top of a slow signal of few bits is none.
bool is_flat(std::span<const double> x, double most) {
  const auto [low, high] = std::ranges::minmax(x);
  const double slope = bits_of_slope * std::min(finest_step(x), coarsest_bit * most);
  for (const double extreme : {low, high}) {
    if (std::abs(extreme) < 0.5 * most) continue;
    for (std::size_t i = 0; i < x.size();) {
      std::size_t end = i;
      while (end < x.size() && x[end] == extreme) ++end;
      const bool steep =
          (i > 0 && std::abs(x[i - 1] - extreme) > slope) || (end < x.size() && std::abs(x[end] - extreme) > slope);
      if (end - i >= flat_samples && steep) return true;
      i = std::max(end, i + 1);
    }
  }
  return false;
}

/// Time in s from the peak to a second blow, which may come before it.
std::optional<double> second_blow(const Record& record, const Blow& blow, double share) {
  const std::vector<double>& force = record.channels[force_channel(record)].samples;
  const std::size_t peak = *blow.peak, end = blow.first + blow.length;
  const auto strong = [&](std::size_t i) { return force[i] / force[peak] > share; };
  const auto time = [&](std::size_t i) { return (static_cast<double>(i) - static_cast<double>(peak)) / record.rate_hz; };
  std::size_t i = peak;
  while (i < end && strong(i)) ++i;
  for (; i < end; ++i) {
    if (strong(i)) return time(i);
  }
  i = peak + 1;
  while (i > blow.first && strong(i - 1)) --i;
  for (; i > blow.first; --i) {
    if (strong(i - 1)) return time(i - 1);
  }
  return std::nullopt;
}

std::string fault_of_channel(const Channel& channel, std::span<const double> x) {
  if (std::ranges::any_of(x, [](double sample) { return !std::isfinite(sample); }))
    return channel.name + " has a sample that is no number";
  const double most = std::abs(x[largest(x, 0, x.size())]);
  if (most == 0.0) return "no signal in " + channel.name;
  return is_flat(x, most) ? fmt::format("overload of {} at {:.4g}", channel.name, most) : std::string();
}

}  // namespace

std::vector<Blow> find_blows(const Record& record, std::size_t index, const HammerOptions& options) {
  if (!options.block_s) return {blow_at(record, index, 0, record.samples())};
  const std::size_t length = samples_of(*options.block_s, record.rate_hz),
                    before = samples_of(options.pretrigger_s, record.rate_hz);
  if (length < 2 || length > record.samples() || before >= length) {
    throw InputError({ErrorKind::usage, record.file, "--block",
                      fmt::format("{:g} s are {} samples, {} of them before the trigger, of a record with {}", *options.block_s,
                                  length, before, record.samples()),
                      "give a block within the record and longer than what comes before the trigger"});
  }
  const std::vector<double>& force = record.channels[force_channel(record)].samples;
  const double peak = force[largest(force, 0, force.size())];
  std::vector<Blow> blows;
  for (std::size_t i = 0; i < force.size();) {
    if (!(force[i] / peak > options.trigger)) {
      ++i;
      continue;
    }
    const std::size_t first = i < before ? 0 : i - before, left = std::min(length, force.size() - first);
    Blow blow = blow_at(record, index, first, left);
    if (i < before)
      blow.rejected = "the record begins too late before it";
    else if (left < length)
      blow.rejected = "the record ends too early after it";
    blows.push_back(std::move(blow));
    i = first + left;
  }
  return blows;
}

std::vector<Blow> find_segments(const Record& record, std::size_t index, std::size_t length, double overlap) {
  const std::size_t step = length - static_cast<std::size_t>(overlap * static_cast<double>(length));
  const std::vector<double>& force = record.channels[force_channels(record).front()].samples;
  std::vector<Blow> segments;
  for (std::size_t first = 0; first + length <= record.samples(); first += step) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + length; ++i) sum += force[i] * force[i];
    segments.push_back({index, first, length, std::nullopt, std::sqrt(sum / static_cast<double>(length))});
  }
  return segments;
}

std::string fault_of(const Record& record, const Blow& blow, const HammerOptions& options) {
  for (const Channel& channel : record.channels) {
    const std::string fault = fault_of_channel(channel, stretch(channel, blow));
    if (!fault.empty()) return fault;
  }
  if (!blow.peak) return {};
  const auto second = second_blow(record, blow, options.second_peak);
  return second ? fmt::format("double impact: {:.3g} ms {} the first hit", 1e3 * std::abs(*second),
                              *second > 0.0 ? "after" : "before")
                : std::string();
}

}  // namespace jointid::records
