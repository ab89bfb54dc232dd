#pragma once

#include "friction/path/element.hpp"

namespace jointid::response {

/// The spring f = k₃q³ of a joint, so that time marching takes it like the other elements. It has no memory: Masing's rule is not
/// for it, and its tangent may grow. k₃ in N/m³.
class CubicSpring final : public friction::Element {
 public:
  explicit CubicSpring(double stiffness) : stiffness_(stiffness) {}

  friction::Response response(double u) const override { return {stiffness_ * u * u * u, 3.0 * stiffness_ * u * u}; }
  double energy(double u) const override { return 0.25 * stiffness_ * u * u * u * u; }
  double limit() const override { return friction::infinity; }
  std::vector<friction::Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override { out[0] = u * u * u; }
  std::unique_ptr<friction::Element> with(std::span<const double> values) const override;

 private:
  double stiffness_;
};

}  // namespace jointid::response
