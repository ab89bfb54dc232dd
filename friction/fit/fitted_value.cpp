#include "friction/fit/fitted_value.hpp"

#include <algorithm>

#include "friction/path/parameter_scale.hpp"

namespace jointid::friction {

std::string name(Knowledge knowledge) {
  constexpr std::array names = {"determined", "extrapolated", "undetermined", "preset"};
  return names[static_cast<std::size_t>(knowledge)];
}

FittedValue fitted_value(const Parameter& parameter, std::optional<double> std_error, double quantile) {
  FittedValue out{parameter.name, parameter.unit, parameter.value, std_error, std::nullopt, Knowledge::undetermined};
  if (!std_error) return out;
  const ParameterScale scale(parameter);
  const double q = scale.free(parameter.value), half = quantile * *std_error / scale.slope(q);
  std::array<double, 2> ends = {scale.value(q - half), scale.value(q + half)};
  if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
  out.ci95 = ends;
  const double room = std::min(parameter.value - parameter.lower, parameter.upper - parameter.value);
  if (quantile * *std_error < room) out.knowledge = Knowledge::determined;
  return out;
}

}  // namespace jointid::friction
