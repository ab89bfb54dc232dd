#include "response/joint/cubic_spring.hpp"

#include <stdexcept>

namespace jointid::response {

std::vector<friction::Parameter> CubicSpring::parameters() const {
  return {{.name = "cubic", .unit = "N/m³", .value = stiffness_, .lower = -friction::infinity}};
}

std::unique_ptr<friction::Element> CubicSpring::with(std::span<const double> values) const {
  if (values.size() != 1) throw std::invalid_argument("a cubic spring has one parameter");
  return std::make_unique<CubicSpring>(values[0]);
}

}  // namespace jointid::response
