#include "friction/path/parameter_scale.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::friction {
namespace {

double logistic(double q) { return 1.0 / (1.0 + std::exp(-q)); }

}  // namespace

double ParameterScale::value(double q) const {
  const bool below = std::isfinite(lower_), above = std::isfinite(upper_);
  if (below && above) return lower_ + (upper_ - lower_) * logistic(q);
  if (below) return lower_ + std::exp(q);
  return above ? upper_ - std::exp(-q) : q;
}

double ParameterScale::slope(double q) const {
  const bool below = std::isfinite(lower_), above = std::isfinite(upper_);
  if (below && above) return (upper_ - lower_) * logistic(q) * logistic(-q);
  if (below) return std::exp(q);
  return above ? std::exp(-q) : 1.0;
}

double ParameterScale::free(double p) const {
  const bool below = std::isfinite(lower_), above = std::isfinite(upper_);
  if (!below && !above) return p;
  constexpr double inside = 1e-9;  // of the range, or of 1
  const double scale = below && above ? upper_ - lower_ : 1e-300;
  const double from_lower = below ? std::max(p - lower_, inside * scale) : 0.0;
  const double from_upper = above ? std::max(upper_ - p, inside * scale) : 0.0;
  if (below && above) return std::log(from_lower / from_upper);
  return below ? std::log(from_lower) : -std::log(from_upper);
}

}  // namespace jointid::friction
