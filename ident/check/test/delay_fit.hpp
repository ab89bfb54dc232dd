#pragma once

#include <complex>
#include <vector>

namespace jointid::ident {

/// A number whose phase should be 0, at an angular frequency; its size is its weight.
struct PhaseSample {
  double omega = 0.0;  ///< rad/s
  std::complex<double> value;
};

struct DelayFit {
  double delay = 0.0, deviation = 0.0;  ///< s
};

/// The τ within ±200 µs that makes Σ Re(z e^{iωτ}) largest, and its standard deviation from the scatter of the phases.
DelayFit fit_delay(const std::vector<PhaseSample>& samples);

}  // namespace jointid::ident
