#include <algorithm>
#include <cmath>

#include "friction/fit/fit_problem.hpp"

namespace jointid::friction {
namespace {

double largest(const std::vector<double>& values) {
  double out = 0.0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

/// Square root of the share of the whole way that lies nearest to each sample.
std::vector<double> roots_of_ways(const std::vector<double>& u) {
  std::vector<double> way(u.size(), 0.0);
  for (std::size_t i = 1; i < u.size(); ++i) {
    const double half = 0.5 * std::abs(u[i] - u[i - 1]);
    way[i - 1] += half;
    way[i] += half;
  }
  double sum = 0.0;
  for (const double each : way) sum += each;
  for (double& each : way) each = std::sqrt(each * static_cast<double>(u.size()) / sum);
  return way;
}

}  // namespace

std::vector<double> row_weights(const Curve& curve, Weighting weighting) {
  std::vector<double> out(curve.rows(), 1.0);
  if (curve.kind == CurveKind::equivalent) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t at = i % curve.u.size();
      out[i] = 1.0 / std::hypot(curve.value[at], curve.damping[at]);
    }
    return out;
  }
  if (weighting == Weighting::none) return out;
  const double scale = largest(curve.value);
  const std::vector<double> ways = weighting == Weighting::travel ? roots_of_ways(curve.u) : out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double force = weighting == Weighting::relative ? std::max(std::abs(curve.value[i]), 0.01 * scale) : scale;
    out[i] = ways[i] / force;
  }
  return out;
}

}  // namespace jointid::friction
