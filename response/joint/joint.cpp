#include "response/joint/joint.hpp"

#include <span>

#include "base/error.hpp"

namespace jointid::response {

std::vector<std::string> Joint::parameter_names() const {
  std::vector<std::string> names;
  if (friction) {
    for (const friction::Parameter& parameter : friction->parameters()) names.push_back(parameter.name);
  }
  names.insert(names.end(), {"stiffness", "damping", "cubic"});
  return names;
}

std::vector<double> Joint::values() const {
  std::vector<double> values = friction ? friction->values() : std::vector<double>{};
  values.insert(values.end(), {stiffness, damping, cubic});
  return values;
}

bool Joint::admits(const std::vector<double>& values) const {
  return values.size() == parameter_names().size() && (!friction || friction->admits(std::span(values).first(values.size() - 3)));
}

Joint Joint::with(const std::vector<double>& values) const {
  if (values.size() != parameter_names().size()) refuse("a joint has as many values as parameters");
  Joint other = *this;
  const std::size_t own = values.size() - 3;
  if (friction) other.friction = friction->with(std::span(values).first(own));
  other.stiffness = values[own];
  other.damping = values[own + 1];
  other.cubic = values[own + 2];
  return other;
}

double Joint::stuck_stiffness() const { return stiffness + (friction ? friction->response(0.0).tangent : 0.0); }

}  // namespace jointid::response
