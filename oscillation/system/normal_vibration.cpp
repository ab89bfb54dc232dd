#include "oscillation/system/normal_vibration.hpp"

#include <cmath>
#include <numbers>

namespace jointid::oscillation {

double NormalVibration::natural_hz() const {
  return std::sqrt((stiffness + extension_stiffness) / mass) / (2.0 * std::numbers::pi);
}

double NormalVibration::static_force() const {
  return offset * stiffness * extension_stiffness / (stiffness + extension_stiffness);
}

double NormalVibration::static_slope() const {
  return slope * stiffness * extension_stiffness / (stiffness + extension_stiffness);
}

NormalMotion normal_motion(const NormalVibration& s, double amplitude, double omega) {
  const std::complex<double> extension(s.extension_stiffness, omega * s.extension_damping);
  const std::complex<double> body(s.stiffness - omega * omega * s.mass, omega * s.damping);
  const double surface = s.slope * amplitude;
  NormalMotion out;
  out.rest = s.extension_stiffness * s.offset / (s.stiffness + s.extension_stiffness);
  out.first = extension * surface / (body + extension);
  out.force = s.static_force();
  out.force_first = extension * (surface - out.first);
  return out;
}

}  // namespace jointid::oscillation
