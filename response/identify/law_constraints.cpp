#include "response/identify/law_constraints.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {
namespace {

/// A value that a fit can start with: between the bounds, at least a twentieth of their distance away.
double inside(double value, double lower, double upper) {
  constexpr double share = 0.05;
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  const double room = share * (below && above ? upper - lower : std::abs(below ? lower : upper));
  const double distance = room > 0.0 ? room : 1e-9;
  if (below && !(value > lower)) value = lower + distance;
  if (above && !(value < upper)) value = upper - distance;
  return value;
}

std::size_t law_parameters(const Joint& joint) { return joint.friction ? joint.friction->parameters().size() : 0; }

/// The unknown parameter of that place, with what the rules say of it.
Unknown unknown_of(std::size_t joint, std::size_t place, const std::string& name, const LawConstraints& constraints) {
  Unknown unknown = {{joint, place}};
  for (const ParameterRule& rule : constraints.rules) {
    if (rule.joint != joint || rule.parameter != name) continue;
    if (rule.bounds) unknown.bounds = rule.bounds;
    if (rule.prior) unknown.prior = rule.prior;
  }
  return unknown;
}

std::vector<Unknown> unknowns_of_joint(const std::vector<Joint>& joints, std::size_t j, const LawConstraints& constraints) {
  std::vector<Unknown> all;
  const std::vector<std::string> names = joints[j].parameter_names();
  const std::size_t of_law = law_parameters(joints[j]);
  for (std::size_t place = 0; place < names.size(); ++place) {
    const bool is_beside = j < constraints.beside.size() && std::ranges::count(constraints.beside[j], names[place]) > 0;
    if (place < of_law ? constraints.leader(j).has_value() : !is_beside) continue;
    all.push_back(unknown_of(j, place, names[place], constraints));
    if (place >= of_law) continue;
    for (std::size_t other = j + 1; other < joints.size(); ++other) {
      if (constraints.leader(other) == j) all.back().ties.push_back({other, place});
    }
  }
  return all;
}

/// The joint with the values of its unknowns inside their bounds.
Joint started_inside(const Joint& joint, const std::vector<Unknown>& unknowns) {
  std::vector<double> values = joint.values();
  const auto parameters = joint.friction ? joint.friction->parameters() : std::vector<friction::Parameter>{};
  for (const Unknown& unknown : unknowns) {
    const std::size_t place = unknown.parameter.parameter;
    double lower = place < parameters.size() ? parameters[place].lower : 0.0;
    double upper = place < parameters.size() ? parameters[place].upper : friction::infinity;
    if (unknown.bounds) {
      lower = std::max(lower, (*unknown.bounds)[0]);
      upper = std::min(upper, (*unknown.bounds)[1]);
    }
    values[place] = inside(values[place], lower, upper);
  }
  return joint.with(values);
}

}  // namespace

LawUnknowns unknowns_of(std::vector<Joint> joints, const LawConstraints& constraints) {
  std::vector<Unknown> all;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (const auto leader = constraints.leader(j)) joints[j].friction = joints[*leader].friction;
    const std::vector<Unknown> own = unknowns_of_joint(joints, j, constraints);
    joints[j] = started_inside(joints[j], own);
    all.insert(all.end(), own.begin(), own.end());
  }
  return {std::move(joints), std::move(all)};
}

}  // namespace jointid::response
