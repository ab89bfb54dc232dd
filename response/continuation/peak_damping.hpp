#pragma once

#include <array>
#include <optional>

#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// Frequency and damping of the mode that makes a peak, as a linear structure has them whose joints keep their F_n/Q_n.
struct PeakMode {
  double omega = 0.0;  ///< rad/s
  double ratio = 0.0;  ///< of critical damping
};

/// h(ω) = X_n over the force's level with the joints' complex stiffnesses held at F_n/Q_n of a solution (dashpots follow ω). Of one
/// mode z = 1/h is proportional to ω_r² − ω² + 2iζω_rω, so z/z′ at nω tells both. z′ is that of the parabola through z at nω and at
/// `beside` (rad/s, below and above it, where the structure is known): z is so nearly quadratic that steps may be as wide as the
/// peak. None where the force has no harmonic n or no mode shows (ω_r² or ζ not above 0). Other modes close by are errors.
std::optional<PeakMode> peak_mode(const HarmonicBalance& balance, const HarmonicSolution& solution, Eigen::Index response,
                                  int harmonic, const std::array<double, 2>& beside);

}  // namespace jointid::response
