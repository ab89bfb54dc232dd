#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

struct LawParameter {
  std::string_view name;
  std::string_view unit;
  double lower;
  double upper;
  bool lower_included = false;
};

/// What a curve shows of any law: roughly its initial stiffness dT/du(0) and its plateau.
struct Features {
  double stiffness = 0.0;
  double limit = 0.0;
};

/// Where a fit of a law to a curve with such features begins.
struct LawStart {
  std::span<const double> shapes;  ///< of what features do not tell: one start for each
  std::vector<double> (*values)(const Features&, double shape);
};

/// A law with a fixed number of parameters.
struct Law {
  std::string_view name;   ///< word for the command line
  std::string_view title;  ///< for tables
  std::span<const LawParameter> parameters;
  LawStart start;
  bool has_limit = true;  ///< macroslip, which a spring does not reach
};

/// True where there are as many values as parameters, each finite and inside its bounds.
bool admits(const Law& law, std::span<const double> values);

/// Throws InputError that names the law, the parameter and its value, unless every value is finite and inside
/// its bounds.
void check_values(const Law& law, std::span<const double> values);

/// The parameters of `law` with values.
std::vector<Parameter> with_values(const Law& law, std::span<const double> values);

}  // namespace jointid::friction
