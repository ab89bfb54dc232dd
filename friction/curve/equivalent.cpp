#include "friction/curve/equivalent.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "friction/path/quadrature.hpp"

namespace jointid::friction {

Equivalent equivalent(const Element& element, double amplitude) {
  if (!(amplitude > 0.0) || !std::isfinite(amplitude)) {
    refuse("equivalent stiffness: amplitude " + std::to_string(amplitude) + " must be finite and > 0");
  }
  Equivalent result = {.amplitude = amplitude};
  result.stiffness = element.equivalent_stiffness(amplitude);
  result.energy = element.cycle_energy(amplitude);
  result.damping = result.energy / (std::numbers::pi * amplitude * amplitude);
  result.loss_factor = result.damping / result.stiffness;
  return result;
}

std::vector<Equivalent> equivalent(const Element& element, std::span<const double> amplitudes) {
  std::vector<Equivalent> result;
  for (const double amplitude : amplitudes) result.push_back(equivalent(element, amplitude));
  return result;
}

EquivalentDerivative equivalent_derivative(const Element& element, double amplitude) {
  using std::numbers::pi;
  std::vector<double> angles = {0.0}, ends = {0.0};
  for (const double kink : element.kinks()) {
    if (kink >= amplitude) continue;
    angles.push_back(2.0 * std::asin(std::sqrt(kink / amplitude)));
    ends.push_back(kink);
  }
  angles.push_back(pi);
  ends.push_back(amplitude);
  std::vector<double> one(element.parameters().size());
  EquivalentDerivative result;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto by_parameter = [&](double u) {
      element.derivative(u, one);
      return one[i];
    };
    const auto in_phase = [&](double angle) {
      const double sine = std::sin(0.5 * angle);
      return by_parameter(amplitude * sine * sine) * std::cos(angle);
    };
    const double energy = 8.0 * integrate(by_parameter, ends) - 4.0 * amplitude * by_parameter(amplitude);
    result.stiffness.push_back(-4.0 / (pi * amplitude) * integrate(in_phase, angles));
    result.damping.push_back(energy / (pi * amplitude * amplitude));
  }
  return result;
}

}  // namespace jointid::friction
