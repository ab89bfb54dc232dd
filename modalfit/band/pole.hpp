#pragma once

namespace jointid::modalfit {

/// A pole of the model: undamped natural frequency ω_r/2π and the damping of the model's kind, ζ_r (viscous) or η_r
/// (hysteretic; η = 2ζ at resonance).
struct Pole {
  double frequency_hz = 0.0;
  double damping = 0.0;
};

}  // namespace jointid::modalfit
