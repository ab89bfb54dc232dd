#include "weighting/line_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jointid::weighting {
namespace {

constexpr double end_tolerance = 1e-9;

bool inside(double frequency, const std::array<double, 2>& interval) {
  return frequency >= interval[0] * (1.0 - end_tolerance) && frequency <= interval[1] * (1.0 + end_tolerance);
}

std::size_t nearest_line(std::span<const double> axis, double frequency) {
  const auto after = std::lower_bound(axis.begin(), axis.end(), frequency);
  std::size_t nearest = static_cast<std::size_t>(after - axis.begin());
  if (nearest == axis.size() || (nearest > 0 && frequency - axis[nearest - 1] < axis[nearest] - frequency)) --nearest;
  return nearest;
}

std::vector<std::size_t> stepped_lines(std::span<const double> axis, const std::array<double, 2>& range, double step) {
  std::vector<std::size_t> lines;
  const auto first_step = static_cast<long long>(std::max(0.0, std::floor((axis.front() - range[0]) / step)));
  for (long long k = first_step;; ++k) {
    const double target = range[0] + static_cast<double>(k) * step;
    if (target > range[1] * (1.0 + end_tolerance)) break;
    const std::size_t line = nearest_line(axis, target);
    if (inside(axis[line], range) && (lines.empty() || line > lines.back())) lines.push_back(line);
    if (target > axis.back()) break;  // all further steps are nearest to the last line, too
  }
  return lines;
}

}  // namespace

std::vector<std::size_t> select_lines(std::span<const double> axis, const LineSelection& selection) {
  if (axis.empty()) return {};
  const std::array<double, 2> range = selection.range_hz.value_or(std::array<double, 2>{axis.front(), axis.back()});
  std::vector<std::size_t> lines;
  // A step finer than the axis selects every line; stepping through it would only cost time.
  const double finest = (axis.back() - axis.front()) / static_cast<double>(axis.size());
  if (selection.step_hz && *selection.step_hz > 0.5 * finest) {
    lines = stepped_lines(axis, range, *selection.step_hz);
  } else {
    for (std::size_t i = 0; i < axis.size(); ++i) {
      if (inside(axis[i], range)) lines.push_back(i);
    }
  }
  std::erase_if(lines, [&](std::size_t line) {
    return std::any_of(selection.exclude_hz.begin(), selection.exclude_hz.end(),
                       [&](const auto& interval) { return inside(axis[line], interval); });
  });
  return lines;
}

std::vector<double> find_resonances(std::span<const double> frequency_hz, std::span<const double> indicator) {
  constexpr double prominence = 2.0;
  const std::size_t lines = frequency_hz.size();
  std::vector<double> strength(lines);
  for (std::size_t i = 0; i < lines; ++i) strength[i] = frequency_hz[i] * frequency_hz[i] * indicator[i];
  std::vector<double> resonances;
  // Walks up and down once: `valley` is the lowest value since the last peak, `peak` the highest since that valley.
  double valley = std::numeric_limits<double>::infinity();
  std::size_t peak = 0;
  bool rising = false;
  for (std::size_t i = 0; i < lines; ++i) {
    if (!(std::isfinite(strength[i]) && strength[i] > 0.0)) continue;  // not measured, or 0 Hz
    if (rising) {
      if (strength[i] > strength[peak]) peak = i;
      if (strength[i] * prominence <= strength[peak]) {
        resonances.push_back(frequency_hz[peak]);
        valley = strength[i];
        rising = false;
      }
    } else {
      valley = std::min(valley, strength[i]);
      if (strength[i] >= prominence * valley) {
        peak = i;
        rising = true;
      }
    }
  }
  return resonances;
}

}  // namespace jointid::weighting
