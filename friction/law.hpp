#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "friction/element.hpp"

namespace jointid::friction {

struct LawParameter {
  std::string_view name;
  std::string_view unit;
  double lower;
  double upper;
  bool lower_included = false;
};

/// A law with a fixed number of parameters.
struct Law {
  std::string_view name;   ///< word for the command line
  std::string_view title;  ///< for tables
  std::span<const LawParameter> parameters;
};

/// All laws that make_element knows, in the order of the documentation.
std::span<const Law> laws();

/// The law of that name. Throws std::invalid_argument with the valid names.
const Law& law(std::string_view name);

/// The law of that name with these parameter values. Throws std::invalid_argument.
std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values);

/// Throws std::invalid_argument that names the law, the parameter and its value, unless every value is finite and inside
/// its bounds.
void check_values(const Law& law, std::span<const double> values);

/// The parameters of `law` with values.
std::vector<Parameter> with_values(const Law& law, std::span<const double> values);

}  // namespace jointid::friction
