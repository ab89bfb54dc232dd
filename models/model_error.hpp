#pragma once

#include <limits>
#include <vector>

namespace jointid::models {

/// What a description states of its model's error: the true stiffness is e^z times that of the model, z ~ N(0, σ²), and the mass
/// likewise; losses and damping ratios are those of the model. One z for all lines of a band.
struct ModelError {
  struct Band {
    double deviation = 0.0;                                                  ///< σ > 0
    double low_hz = 0.0, high_hz = std::numeric_limits<double>::infinity();  ///< low ≤ f < high

    bool has(double frequency_hz) const { return frequency_hz >= low_hz && frequency_hz < high_hz; }
  };
  std::vector<Band> stiffness, mass;

  bool any() const { return !stiffness.empty() || !mass.empty(); }
};

}  // namespace jointid::models
