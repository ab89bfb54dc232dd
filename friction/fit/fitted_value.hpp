#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "friction/path/element.hpp"

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

/// Slipped share from which macroslip counts as reached.
inline constexpr double macroslip = 0.98;

std::string name(Knowledge knowledge);

/// The value of a parameter with its interval of ± quantile · std_error on the scale of its bounds: determined where that is less
/// than the distance of the value from its bounds.
FittedValue fitted_value(const Parameter& parameter, std::optional<double> std_error, double quantile);

}  // namespace jointid::friction
