#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "response/identify/law_unknowns.hpp"

namespace jointid::response {

/// What is known of one parameter of a joint beforehand, by its name in Joint::parameter_names(). A rule of a parameter that the
/// joint's law does not have says nothing.
struct ParameterRule {
  std::size_t joint = 0;
  std::string parameter;
  std::optional<std::array<double, 2>> bounds{};  ///< inside those of the law
  std::optional<std::array<double, 2>> prior{};   ///< value and standard deviation, of an earlier test
};

/// What is known of the laws of joints beforehand, and what is unknown beside them.
struct LawConstraints {
  std::vector<std::optional<std::size_t>> tied_to{};  ///< of each joint the one before it whose law it has; empty: none is tied
  std::vector<std::vector<std::string>> beside{};     ///< of each joint the unknown ones of stiffness, damping, cubic
  std::vector<ParameterRule> rules{};

  std::optional<std::size_t> leader(std::size_t joint) const { return joint < tied_to.size() ? tied_to[joint] : std::nullopt; }
};

/// All parameters of the friction laws and those beside them, as the constraints say; values outside their bounds start a little
/// inside, tied joints with the law of the one they are tied to.
LawUnknowns unknowns_of(std::vector<Joint> joints, const LawConstraints& constraints);

}  // namespace jointid::response
