#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace jointid::friction {

/// What the data say of a number.
enum class Knowledge : std::uint8_t {
  determined,
  extrapolated,  ///< of the friction limit: macroslip was not reached, the number is the law's continuation
  undetermined,  ///< its value ± t·s.e. reaches a bound, e.g. zero, or nothing in the data depends on it
  preset,
};

/// A fitted number. The interval is symmetric on the scale of its ParameterScale, so it keeps to the bounds.
struct FittedValue {
  std::string name, unit;
  double value = 0.0;
  std::optional<double> std_error;
  std::optional<std::array<double, 2>> ci95;
  Knowledge knowledge = Knowledge::determined;
};

std::string name(Knowledge knowledge);

}  // namespace jointid::friction
