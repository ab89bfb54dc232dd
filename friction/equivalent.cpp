#include "friction/equivalent.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace jointid::friction {

Equivalent equivalent(const Element& element, double amplitude) {
  if (!(amplitude > 0.0) || !std::isfinite(amplitude)) {
    throw std::invalid_argument("equivalent stiffness: amplitude " + std::to_string(amplitude) + " must be finite and > 0");
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

}  // namespace jointid::friction
