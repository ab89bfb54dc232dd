#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"

namespace jointid::tasks {

/// What an unknown of one solution is beside that of another: two tightenings, or before and after.
struct UnknownDifference {
  std::string name, unit;
  double first = 0.0, second = 0.0;
  std::optional<double> first_half, second_half;  ///< of the 95 % intervals, or the errors of linear methods
  double difference = 0.0;                        ///< second less first
  std::optional<double> half;  ///< √(first² + second²), as of two tests with errors of their own; empty where one has none
  double relative = 0.0;       ///< difference over |first|; NaN of 0
  /// Whether the interval of the difference leaves out zero.
  bool differs() const { return half && (difference > *half || difference < -*half); }
};

/// Unknowns that both have with the same name and unit, and both determine, in the order of the first. Names and units are those of
/// Estimate.
std::vector<UnknownDifference> run_differences(const std::vector<ident::Estimate>& first, const std::vector<ident::Estimate>& second);

}  // namespace jointid::tasks
