#pragma once

#include "friction/path/element.hpp"

namespace jointid::friction {

/// A parameter p between its bounds as a number q without any, so that a fit needs no bounds:
/// p = lower + e^q, upper − e^{−q}, or the logistic curve between two finite bounds.
class ParameterScale {
 public:
  explicit ParameterScale(const Parameter& parameter) : lower_(parameter.lower), upper_(parameter.upper) {}

  /// p of q; strictly inside the bounds, or at them where rounding leaves no room.
  double value(double q) const;
  /// dp/dq.
  double slope(double q) const;
  /// q of p; p at a bound is taken a little inside.
  double free(double p) const;

 private:
  double lower_, upper_;
};

}  // namespace jointid::friction
