#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// A unit as a factor to SI and exponents of length, time and force; angles are pure numbers.
struct Unit {
  double si = 1.0;
  int length = 0;
  int time = 0;
  int force = 0;

  bool same_dimension(const Unit& other) const { return length == other.length && time == other.time && force == other.force; }
};

/// Parses a unit label (ASCII or UTF-8), e.g. "m/s^2/N", "(mm/s²)/N", "m/(s^2*N)", "1/kg". Units: unit_names(); between them * · . blank
/// or /, from left to right, and parentheses; powers −9 … 9 as ^2 ^-2 **2 ² ³ ⁻² or a number (s2). Empty when any of it is something
/// else, so that a label is used only when all of it is understood.
std::optional<Unit> parse_unit(std::string_view label);

/// "m cm mm …", for messages.
std::string unit_names();

}  // namespace jointid::frf
