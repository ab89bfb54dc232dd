#include "friction/fit/fit_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "friction/law/arrangement.hpp"
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

/// Shares of the stiffness (side by side) or of the flexibility (one behind the other) that parts may have.
std::vector<std::vector<double>> splits(std::size_t parts) {
  if (parts > 2) return {std::vector<double>(parts, 1.0 / static_cast<double>(parts))};
  return {{0.2, 0.8}, {0.5, 0.5}, {0.8, 0.2}};
}

/// Features of the parts of an arrangement that has those of `whole`. In series one part has the limit, the others more.
std::vector<std::vector<Features>> part_features(const ArrangementName& arrangement, const Features& whole) {
  std::vector<std::vector<Features>> all;
  const std::size_t count = arrangement.parts.size();
  for (const std::vector<double>& split : splits(count)) {
    for (std::size_t weakest = 0; weakest < (arrangement.series ? count : 1); ++weakest) {
      std::vector<Features>& parts = all.emplace_back();
      for (std::size_t i = 0; i < count; ++i) {
        if (!arrangement.series) parts.push_back({split[i] * whole.stiffness, split[i] * whole.limit});
        if (arrangement.series) parts.push_back({whole.stiffness / split[i], (i == weakest ? 1.0 : 1.5) * whole.limit});
      }
    }
  }
  return all;
}

/// At most two shapes of a law that is part of an arrangement.
std::vector<double> part_shapes(const Law& law) {
  const auto shapes = law.start.shapes;
  if (shapes.size() <= 2) return {shapes.begin(), shapes.end()};
  return {shapes[shapes.size() / 3], shapes[2 * shapes.size() / 3]};
}

/// Elements of every combination of shapes.
void add_combinations(const std::string& name, const std::vector<const Law*>& laws, const std::vector<Features>& features,
                      std::vector<double> values, std::size_t part, Elements& out) {
  if (part == laws.size()) {
    out.push_back(make_element(name, values));
    return;
  }
  for (const double shape : part_shapes(*laws[part])) {
    std::vector<double> longer = values;
    for (const double value : laws[part]->start.values(features[part], shape)) longer.push_back(value);
    add_combinations(name, laws, features, std::move(longer), part + 1, out);
  }
}

Family arrangement_family(const std::string& name) {
  const auto starts = [name](const Features& seen) {
    const ArrangementName arrangement = parse_arrangement(name);
    std::vector<const Law*> parts;
    for (const std::string& part : arrangement.parts) parts.push_back(&law(part));
    Elements out;
    for (const Features& each : around(seen)) {
      for (const std::vector<Features>& features : part_features(arrangement, each))
        add_combinations(name, parts, features, {}, 0, out);
    }
    return out;
  };
  return {name, std::string(law(name).title), starts};
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
  if (is_arrangement(name)) return arrangement_family(name);
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
