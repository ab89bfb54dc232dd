#include "response/joint/cubic_spring.hpp"

#include "base/error.hpp"

namespace jointid::response {

std::vector<friction::Parameter> CubicSpring::parameters() const {
  return {{.name = "cubic", .unit = "N/m³", .value = stiffness_, .lower = -friction::infinity}};
}

std::unique_ptr<friction::Element> CubicSpring::with(std::span<const double> values) const {
  if (!admits(values)) refuse("a cubic spring has one parameter, and that is finite");
  return std::make_unique<CubicSpring>(values[0]);
}

}  // namespace jointid::response
