#include "response/structure/infinite_receptance.hpp"

#include <string>

#include "base/error.hpp"

namespace jointid::response {

void infinite_receptance(double omega) {
  throw InputError({.kind = ErrorKind::data,
                    .file = "",
                    .place = "[structure]",
                    .problem = "the receptance is infinite at " + std::to_string(omega) + " rad/s",
                    .remedy = omega == 0.0
                                  ? "a structure that is free to move has no mean position: use odd harmonics and no mean force"
                                  : "an undamped resonance: add damping or choose another frequency"});
}

void require_finite(const Eigen::MatrixXcd& h, double omega) {
  if (!h.allFinite()) infinite_receptance(omega);
}

}  // namespace jointid::response
