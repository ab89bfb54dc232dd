#include "response/fourier/loading_levels.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {
namespace {

constexpr double level_ratio = 4.0;      ///< of the ends of a piece: a law singular at 0 is analytic in a wide ellipse about it
constexpr double negligible = 1e-18;     ///< share of the initial tangent
constexpr double least_share = 0x1p-32;  ///< of the scale: below it T is as good as linear
constexpr int most_levels = 60;

/// u > 0 where T′ has fallen to half of T′(0), by doubling and halving; +infinity when it never does.
double half_tangent(const friction::Element& element) {
  const double half = 0.5 * element.response(0.0).tangent;
  const auto fallen = [&](double u) { return element.response(u).tangent <= half; };
  double u = 1.0;
  for (int i = 0; i < 500 && !fallen(u); ++i) u *= 2.0;
  if (!fallen(u)) return friction::infinity;
  for (int i = 0; i < 1000 && u > 0.0 && fallen(0.5 * u); ++i) u *= 0.5;
  return u;
}

}  // namespace

LoadingLevels::LoadingLevels(const friction::Element& element) : scale_(half_tangent(element)), levels_(element.kinks()) {
  const double end = levels_.empty() || !std::isfinite(element.limit()) ? friction::infinity : levels_.back();
  if (!levels_.empty()) scale_ = std::min(scale_, levels_.front());
  if (!std::isfinite(scale_)) return;
  const double least = negligible * element.response(0.0).tangent;
  double u = scale_;
  for (int i = 0; i < most_levels && u < end && element.response(u).tangent > least; ++i, u *= level_ratio) levels_.push_back(u);
  std::ranges::sort(levels_);
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
}

std::vector<double> LoadingLevels::between(double from, double to) const {
  std::vector<double> inside;
  if (from > 0.0 && std::isfinite(scale_)) {
    for (double u = std::max(level_ratio * from, least_share * scale_); u < std::min(to, scale_); u *= level_ratio)
      inside.push_back(u);
  }
  for (const double level : levels_) {
    if (level > from && level < to) inside.push_back(level);
  }
  return inside;
}

}  // namespace jointid::response
