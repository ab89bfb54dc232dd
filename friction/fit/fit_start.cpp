#include "friction/fit/fit_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/text.hpp"
#include "friction/law/laws.hpp"
#include "friction/path/ring.hpp"

namespace jointid::friction {
namespace {

using Elements = std::vector<std::unique_ptr<Element>>;

Features features_of_loading(const std::vector<double>& u, const std::vector<double>& force) {
  double largest = 0.0, uu = 0.0, uf = 0.0;
  for (const double each : force) largest = std::max(largest, std::abs(each));
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (std::abs(force[i]) > 0.3 * largest) continue;
    uu += u[i] * u[i];
    uf += u[i] * force[i];
  }
  double secant = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) secant = std::max(secant, u[i] != 0.0 ? force[i] / u[i] : 0.0);
  return {uf > 0.0 ? uf / uu : secant, largest};
}

/// E = 4T(X − u_s) after macroslip: the limit from the last two amplitudes, the stiffness from where that line begins.
Features features_of_energies(const Curve& curve) {
  const auto last = static_cast<std::size_t>(std::ranges::max_element(curve.u) - curve.u.begin());
  const auto first = static_cast<std::size_t>(std::ranges::min_element(curve.u) - curve.u.begin());
  const double slope = (curve.value[last] - curve.value[first]) / (4.0 * (curve.u[last] - curve.u[first]));
  const double limit = first == last || !(slope > 0.0) ? 0.25 * curve.value[last] / curve.u[last] : slope;
  return {4.0 * limit / curve.u[last], limit};
}

Features features_of_equivalents(const Curve& curve) {
  const auto last = static_cast<std::size_t>(std::ranges::max_element(curve.u) - curve.u.begin());
  const double stiffness = *std::ranges::max_element(curve.value);
  const double from_damping = 0.25 * std::numbers::pi * curve.u[last] * curve.damping[last];
  return {stiffness, std::max(from_damping, 0.5 * curve.value[last] * curve.u[last])};
}

/// Features times the factors that the first look at a curve is usually off by.
std::vector<Features> around(const Features& seen) {
  std::vector<Features> out;
  for (const double limit : {0.95, 1.02, 1.3, 2.5}) {
    for (const double stiffness : {1.0, 1.4, 4.0}) out.push_back({stiffness * seen.stiffness, limit * seen.limit});
  }
  return out;
}

const Law& law_to_fit(const std::string& name) {
  const auto found = std::ranges::find(laws(), name, &Law::name);
  if (found != laws().end()) return *found;
  refuse("no friction law '" + name + "' can be fitted by name; valid: " + comma_list(fitted_laws()));
}

}  // namespace

Features features(const Curve& curve) {
  if (curve.kind == CurveKind::energy) return features_of_energies(curve);
  if (curve.kind == CurveKind::equivalent) return features_of_equivalents(curve);
  if (curve.kind == CurveKind::loading) return features_of_loading(curve.u, curve.value);
  const Record halves = masing_curve({{curve.u, curve.value}, curve.turn});
  return features_of_loading(halves.displacement, halves.force);
}

Family family(const std::string& name) {
  const Law& found = law_to_fit(name);
  const auto starts = [&found](const Features& seen) {
    Elements out;
    for (const Features& each : around(seen)) {
      for (const double shape : found.start.shapes) out.push_back(make_element(found.name, found.start.values(each, shape)));
    }
    return out;
  };
  return {name, std::string(found.title), starts};
}

Family ring_family(const std::string& name, double inner, double outer) {
  const Family flat = family(name);
  const auto starts = [flat, inner, outer](const Features& seen) {
    const double stiffness = 0.5 * std::numbers::pi * (std::pow(outer, 4) - std::pow(inner, 4));
    const double limit = 2.0 / 3.0 * std::numbers::pi * (std::pow(outer, 3) - std::pow(inner, 3));
    Elements out;
    for (auto& each : flat.starts({seen.stiffness / stiffness, seen.limit / limit})) {
      out.push_back(std::make_unique<Ring>(std::move(each), inner, outer));
    }
    return out;
  };
  return {name, flat.title + ", rotary", starts};
}

std::vector<std::string> fitted_laws() {
  std::vector<std::string> out;
  for (const Law& each : laws()) out.emplace_back(each.name);
  return out;
}

}  // namespace jointid::friction
