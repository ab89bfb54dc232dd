#pragma once

#include <memory>
#include <string>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::response {

/// Force of one joint on the positive end of its relative coordinate q: a friction element along the history of q, with a spring,
/// a dashpot and a cubic spring, f = f_friction[q] + kq + cq̇ + k₃q³.
struct Joint {
  std::string name{};                                   ///< for tables and messages
  std::shared_ptr<const friction::Element> friction{};  ///< none when empty
  double stiffness = 0.0;                               ///< k, N/m
  double damping = 0.0;                                 ///< c, N·s/m
  double cubic = 0.0;                                   ///< k₃, N/m³

  /// Parameters of a joint's derivatives: those of the friction element, then stiffness, damping, cubic.
  std::vector<std::string> parameter_names() const;
  std::vector<double> values() const;

  /// True if the friction law admits its part of the values, in the same order.
  bool admits(const std::vector<double>& values) const;

  /// The joint with other values, in the same order. Throws InputError if the friction law has no such parameters.
  Joint with(const std::vector<double>& values) const;

  /// Tangent of the sticking joint: T′(0) + k.
  double stuck_stiffness() const;
};

}  // namespace jointid::response
