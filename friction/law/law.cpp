#include "friction/law/law.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

bool inside(const LawParameter& parameter, double value) {
  const bool above = parameter.lower_included ? value >= parameter.lower : value > parameter.lower;
  return std::isfinite(value) && above && value < parameter.upper;
}

std::string bounds(const LawParameter& parameter) {
  std::string text;
  if (std::isfinite(parameter.lower)) text = (parameter.lower_included ? ">= " : "> ") + std::to_string(parameter.lower);
  if (std::isfinite(parameter.upper)) text += (text.empty() ? "< " : " and < ") + std::to_string(parameter.upper);
  return text;
}

}  // namespace

bool admits(const Law& law, std::span<const double> values) {
  return std::ranges::equal(law.parameters, values, inside);
}

void check_values(const Law& law, std::span<const double> values) {
  const std::string name(law.name);
  if (values.size() != law.parameters.size()) {
    refuse(name + ": " + std::to_string(values.size()) + " values for " +
                                std::to_string(law.parameters.size()) + " parameters");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& parameter = law.parameters[i];
    if (inside(parameter, values[i])) continue;
    refuse(name + ": " + std::string(parameter.name) + " = " + std::to_string(values[i]) + " " +
                                std::string(parameter.unit) + " must be finite and " + bounds(parameter));
  }
}

std::vector<Parameter> with_values(const Law& law, std::span<const double> values) {
  std::vector<Parameter> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& p = law.parameters[i];
    result.push_back({std::string(p.name), std::string(p.unit), values[i], p.lower, p.upper, p.lower_included});
  }
  return result;
}

}  // namespace jointid::friction
