#include "ident/variance/noise_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

struct Law {
  double a = 0.0, b = 0.0;
  double at(const SquaredError& sample) const { return a * sample.proportional + b * sample.constant; }
};

/// The quantile of Gamma(freedom)/freedom at the normal quantile z (Wilson & Hilferty 1931).
double quantile(double freedom, double z) {
  const double root = 1.0 - 1.0 / (9.0 * freedom) + z / (3.0 * std::sqrt(freedom));
  return root * root * root;
}

/// The law of one term that has the samples' median, and how far the samples scatter about it (median |log|).
struct Start {
  Law law;
  double spread = 0.0;
};

Start start(std::span<const SquaredError> samples, Law shape) {
  std::vector<double> ratios, logs;
  for (const SquaredError& sample : samples) {
    if (shape.at(sample) > 0.0) ratios.push_back(sample.square / shape.at(sample) / quantile(sample.freedom, 0.0));
  }
  if (ratios.empty()) return {{}, INFINITY};
  const double scale = median(ratios);
  if (!(scale > 0.0)) return {{}, INFINITY};
  for (const double ratio : ratios) logs.push_back(std::abs(std::log(std::max(ratio / scale, 1e-300))));
  return {{shape.a * scale, shape.b * scale}, median(logs)};
}

/// Weighted least squares with a, b ≥ 0.
Law least_squares(std::span<const SquaredError> samples, const Law& before) {
  double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0;
  constexpr double far = 3.09;
  for (const SquaredError& sample : samples) {
    const double expected = before.at(sample);
    if (!(expected > 0.0) || sample.square > expected * quantile(sample.freedom, far)) continue;
    const double weight = sample.freedom / (expected * expected);
    uu += weight * sample.proportional * sample.proportional;
    uv += weight * sample.proportional * sample.constant;
    vv += weight * sample.constant * sample.constant;
    uy += weight * sample.proportional * sample.square;
    vy += weight * sample.constant * sample.square;
  }
  const double determinant = uu * vv - uv * uv;
  const Law both{(vv * uy - uv * vy) / determinant, (uu * vy - uv * uy) / determinant};
  if (determinant > 1e-12 * uu * vv && both.a >= 0.0 && both.b >= 0.0) return both;
  const Law first{uu > 0.0 ? uy / uu : 0.0, 0.0}, second{0.0, vv > 0.0 ? vy / vv : 0.0};
  const double gain_first = first.a * uy, gain_second = second.b * vy;
  return gain_first >= gain_second ? first : second;
}

}  // namespace

frf::VarianceLaw fit_noise(std::span<const SquaredError> samples) {
  double scale = 0.0, count = 0.0;
  for (const SquaredError& sample : samples) {
    scale += sample.proportional;
    count += sample.constant;
  }
  if (samples.empty() || count == 0.0) return {};
  scale /= count;
  std::vector<SquaredError> scaled(samples.begin(), samples.end());
  if (scale > 0.0) {
    for (SquaredError& sample : scaled) {
      sample.square /= scale;
      sample.proportional /= scale;
    }
  }
  const Start relative = start(scaled, {1.0, 0.0}), absolute = start(scaled, {0.0, 1.0});
  Law law = relative.spread <= absolute.spread ? relative.law : absolute.law;
  for (int i = 0; i < 20; ++i) law = least_squares(scaled, law);
  return {.proportional = 0.5 * law.a, .constant = 0.5 * law.b * (scale > 0.0 ? scale : 1.0), .by_part = false};
}

}  // namespace jointid::ident
