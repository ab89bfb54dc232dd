#include "frf/polar/phase_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "frf/text/label_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {

void PhaseUnit::add(std::span<const double> phases) {
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double phase : phases) {
    if (std::isfinite(phase)) {
      least_ = count_ == 0 ? phase : std::min(least_, phase);
      most_ = count_ == 0 ? phase : std::max(most_, phase);
      ++count_;
    }
    if (std::isfinite(phase - before)) largest_step_ = std::max(largest_step_, std::abs(phase - before));
    before = phase;
  }
}

AngleUnit PhaseUnit::unit() const {
  constexpr double half = std::numbers::pi, rounding = 1e-5;
  constexpr std::size_t fewest = 8;
  const double largest = std::max(-least_, most_), range = most_ - least_;
  if (count_ < fewest) return AngleUnit::unstated;
  if (largest > 2.0 * half * (1.0 + rounding))
    return largest_step_ > half * (1.0 + rounding) ? AngleUnit::degrees : AngleUnit::unstated;
  const bool half_turns = largest >= 3.0 && largest <= half * (1.0 + rounding) && range > 2.5;
  const bool turns = least_ >= -rounding && most_ >= 6.0 && range > 5.0;
  return half_turns || turns ? AngleUnit::radians : AngleUnit::unstated;
}

AngleUnit angle_unit(std::string_view label) {
  constexpr std::array<std::string_view, 6> degrees = {"deg", "degs", "degree", "degrees", "°", "º"};
  constexpr std::array<std::string_view, 4> radians = {"rad", "rads", "radian", "radians"};
  std::string text = lower_case(utf8_label(without_brackets(without_padding(label))));
  if (text.ends_with('.')) text.pop_back();
  if (std::ranges::find(degrees, text) != degrees.end()) return AngleUnit::degrees;
  return std::ranges::find(radians, text) != radians.end() ? AngleUnit::radians : AngleUnit::unstated;
}

}  // namespace jointid::frf
