#include "frf/polar/polar_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace jointid::frf {
namespace {

constexpr std::size_t fewest_polar_lines = 8;
constexpr double polar_rounding = 1e-5;
constexpr std::array<const char*, 2> angle_words = {"radians", "degrees"};

bool is_finite_pair(const Complex& value) { return std::isfinite(value.real()) && std::isfinite(value.imag()); }

/// b where a has fallen to `level` between the lines `outer` and `inner`.
double at_level(std::span<const Complex> frf, std::size_t outer, std::size_t inner, double level) {
  const Complex step = frf[inner] - frf[outer];
  return frf[outer].imag() + (level - frf[outer].real()) / step.real() * step.imag();
}

}  // namespace

void PolarOrder::add(std::span<const Complex> frf) {
  std::vector<Complex> finite;
  std::ranges::copy_if(frf, std::back_inserter(finite), is_finite_pair);
  for (const Complex& value : finite) {
    above_ = above_ || value.real() > 0.0;
    below_ = below_ || value.real() < 0.0;
    least_ = std::min(least_, value.imag());
    most_ = std::max(most_, value.imag());
    for (std::size_t unit = 0; unit < halves.size(); ++unit) at_half_turns_[unit] += std::abs(value.imag()) >= 0.9 * halves[unit] ? 1U : 0U;
  }
  values_ += finite.size();
  if (!may_be() || finite.size() < fewest_polar_lines) return;
  ++frfs_;
  look_for_wraps(finite);
  look_for_levels(finite);
  look_for_turns(finite);
  look_at_sizes(finite);
}

void PolarOrder::look_for_wraps(std::span<const Complex> frf) {
  for (std::size_t line = 0; line + 1 < frf.size(); ++line) {
    const double leap = std::abs(frf[line + 1].imag() - frf[line].imag());
    for (std::size_t unit = 0; unit < halves.size(); ++unit) {
      if (leap < 1.8 * halves[unit] || leap > 2.0 * halves[unit] * (1.0 + polar_rounding)) continue;
      for (const bool from_zero : {false, true}) {
        std::optional<Leap>& found = wraps_[unit][from_zero ? 1 : 0];
        if (!found && stays_at_edge(frf, line, halves[unit], from_zero ? 0.0 : -halves[unit]))
          found = Leap{frf[line].imag(), frf[line + 1].imag()};
      }
    }
  }
}

bool PolarOrder::stays_at_edge(std::span<const Complex> frf, std::size_t line, double half, double low) const {
  constexpr std::size_t reach = 2, fewest = 5;
  const std::size_t first = line - std::min(line, reach), last = std::min(line + 1 + reach, frf.size() - 1);
  if (last - first + 1 < fewest) return false;
  double least = std::abs(frf[line].real()), most = least;
  for (std::size_t k = first; k <= last; ++k) {
    const double above = frf[k].imag() - low;
    if (std::min(above, 2.0 * half - above) > 0.2 * half) return false;
    least = std::min(least, std::abs(frf[k].real()));
    most = std::max(most, std::abs(frf[k].real()));
  }
  return most <= 3.0 * least;
}

void PolarOrder::look_for_levels(std::span<const Complex> frf) {
  constexpr double near = 0.04;
  constexpr std::size_t shortest_run = 4, fewest = 6;
  for (std::size_t unit = 0; unit < halves.size(); ++unit) {
    const auto quarters = [&](std::size_t line) { return frf[line].imag() / (0.5 * halves[unit]); };
    const auto level = [&](std::size_t line) -> std::optional<int> {
      const double turned = quarters(line), whole = std::round(turned);
      if (!(std::abs(turned - whole) <= near)) return std::nullopt;
      return static_cast<int>(std::fmod(std::fmod(whole, 4.0) + 4.0, 4.0));
    };
    std::map<int, std::size_t> lines_at;
    std::size_t between = 0;
    for (std::size_t line = 0; line < frf.size();) {
      const auto own = level(line);
      std::size_t end = line + 1;
      while (own && end < frf.size() && level(end) == own) ++end;
      if (!own) ++between;
      if (own && end - line >= shortest_run) lines_at[*own] += end - line;
      line = end;
    }
    std::vector<std::size_t> counts;
    for (const auto& [at, count] : lines_at) counts.push_back(count);
    std::ranges::sort(counts);
    levels_[unit] = levels_[unit] || (counts.size() > 1 && counts[counts.size() - 2] >= fewest && between <= 3 * counts[counts.size() - 2]);
  }
}

void PolarOrder::look_for_turns(std::span<const Complex> frf) {
  for (std::size_t peak = 1; peak + 1 < frf.size(); ++peak) {
    const double height = frf[peak].real(), level = height / std::sqrt(2.0);
    if (!(height >= frf[peak - 1].real() && height > frf[peak + 1].real())) continue;
    std::size_t left = peak, right = peak;
    while (left > 0 && frf[left].real() > level && frf[left - 1].real() <= frf[left].real()) --left;
    while (right + 1 < frf.size() && frf[right].real() > level && frf[right + 1].real() <= frf[right].real()) ++right;
    if (frf[left].real() > level || frf[right].real() > level || peak - left < 2 || right - peak < 2) continue;
    const double turned = std::abs(at_level(frf, left, left + 1, level) - at_level(frf, right, right - 1, level));
    for (std::size_t unit = 0; unit < halves.size(); ++unit) {
      Turns& turns = turns_[unit];
      ++turns.peaks;
      if (!(std::abs(turned / (0.5 * halves[unit]) - 1.0) < 0.2)) continue;
      turns.lowest = turns.right == 0 ? height : std::min(turns.lowest, height);
      turns.highest = std::max(turns.highest, height);
      ++turns.right;
    }
  }
}

void PolarOrder::look_at_sizes(std::span<const Complex> frf) {
  const auto large = std::ranges::count_if(
      frf, [](const Complex& value) { return value.real() > 0.0 && std::abs(value.imag()) >= 100.0 * value.real(); });
  if (static_cast<double>(large) >= 0.8 * static_cast<double>(frf.size())) ++large_;
}

bool PolarOrder::within(double low, double high) const {
  const double tolerance = polar_rounding * (high - low);
  return least_ >= low - tolerance && most_ <= high + tolerance;
}

bool PolarOrder::turns_right(std::size_t unit) const {
  const Turns& turns = turns_[unit];
  const double half = halves[unit];
  return turns.right >= 2 && 2 * turns.right >= turns.peaks &&
         (turns.highest < 0.05 * half || turns.lowest > 5.0 * half || turns.highest > 8.0 * turns.lowest);
}

std::string PolarOrder::signs() const {
  return std::string("no ") + (phase_first_ ? "second" : "first") + " number is " + (below_ ? "above 0" : "below 0");
}

std::optional<std::string> PolarOrder::finding() const {
  if (!may_be() || frfs_ == 0 || (phase_first_ && below_)) return std::nullopt;
  const double largest = std::max(-least_, most_);
  const std::string other = phase_first_ ? ", and the first " : ", and the second ";
  for (std::size_t unit = 0; unit < halves.size(); ++unit) {
    const double half = halves[unit];
    const std::string begin = phase_first_ ? std::string("phases in ") + angle_words[unit] + " and magnitudes: " + signs()
                                           : std::string("magnitudes and phases in ") + angle_words[unit] + ": " + signs();
    for (const bool from_zero : {false, true}) {
      const double low = from_zero ? 0.0 : -half;
      const std::optional<Leap>& wrap = wraps_[unit][from_zero ? 1 : 0];
      if (wrap && within(low, low + 2.0 * half))
        return begin + other + fmt::format("goes from {:.4g} to {:.4g} in one line, a whole turn", wrap->from, wrap->to);
    }
    if (levels_[unit] && largest >= 0.45 * half && !phase_first_)
      return begin + other + "stays at multiples of a right angle on most lines";
    if (turns_right(unit) && !below_ && !phase_first_)
      return begin + other + "turns by a right angle over each peak of the first, high or low";
  }
  const bool sizes = !phase_first_ && quantity_ != Quantity::mobility && !below_ && large_ == frfs_;
  if (sizes && largest >= 0.3 && within(-360.0, 360.0))
    return "magnitudes and phases: " + signs() + other + "is 100 times the first or more on most lines";
  return std::nullopt;
}

bool PolarOrder::ends_at_a_turn(std::size_t unit) const {
  constexpr double close = 0.9;
  const double half = halves[unit], largest = std::max(-least_, most_);
  return (within(-half, half) && largest > close * half) || (within(0.0, 2.0 * half) && largest > 2.0 * close * half);
}

std::optional<std::string> PolarOrder::doubt() const {
  constexpr std::size_t one_in = 5;
  if (!may_be() || below_ || !above_ || frfs_ == 0) return std::nullopt;
  bool doubtful = false;
  for (std::size_t unit = 0; unit < halves.size(); ++unit) {
    const bool like_phases = !phase_first_ || levels_[unit] || one_in * at_half_turns_[unit] >= values_;
    doubtful = doubtful || (like_phases && ends_at_a_turn(unit)) || (phase_first_ && turns_right(unit));
  }
  if (!doubtful) return std::nullopt;
  return fmt::format("no {} part is below 0, and the {} parts end at {:.4g}, as if they were {}", phase_first_ ? "imaginary" : "real",
                     phase_first_ ? "real" : "imaginary", -least_ > most_ ? least_ : most_,
                     phase_first_ ? "phases and magnitudes" : "magnitudes and phases");
}

void PolarSearch::add(std::span<const Complex> frf) {
  if (magnitude_first_.may_be()) magnitude_first_.add(frf);
  if (!phase_first_.may_be()) return;
  std::vector<Complex> exchanged;
  for (const Complex& value : frf) exchanged.emplace_back(value.imag(), value.real());
  phase_first_.add(exchanged);
}

void PolarSearch::add(std::span<const Complex> values, std::size_t frfs) {
  std::vector<Complex> one;
  for (std::size_t k = 0; k < frfs && may_be(); ++k) {
    one.clear();
    for (std::size_t at = k; at < values.size(); at += frfs) one.push_back(values[at]);
    add(one);
  }
}

std::optional<std::string> PolarSearch::finding() const {
  const auto found = magnitude_first_.finding();
  return found ? found : phase_first_.finding();
}

std::optional<std::string> PolarSearch::doubt() const {
  if (finding()) return std::nullopt;
  const auto doubt = magnitude_first_.doubt();
  return doubt ? doubt : phase_first_.doubt();
}

}  // namespace jointid::frf
