#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"

namespace jointid::modalfit {

/// A pole of one order of the polyreference fit.
struct CandidatePole {
  double frequency_hz = 0.0;  ///< |s|/2π
  double damping = 0.0;       ///< ζ = −Re s/|s|; negative: unstable
  double deviation_hz = 0.0;  ///< standard deviation of the pole's frequency, first order, from the residual of the fit
};

struct PolyreferenceOptions {
  std::size_t inputs = 3;      ///< references (or responses, where there are fewer) taken together, ≥ 1
  std::size_t most_poles = 80; ///< pole pairs of the highest order, ≥ 2
  std::size_t orders = 40;     ///< at most so many orders, ≥ 1
  std::size_t most_outputs = 400; ///< of more, so many are taken, evenly thinned
};

/// Poles of increasing order.
struct OrderPoles {
  std::size_t order = 0;  ///< pole pairs
  std::vector<CandidatePole> poles;
};

/// Weighted poly-reference least squares in the frequency domain (Guillaume et al., IMAC 2003; Peeters et al., Shock and Vibration
/// 11 (2004) 395–409): per response o, H_o(ω) ≈ B_o(z) A(z)⁻¹ with real polynomial coefficients in z = exp(iφ(ω)), φ mapped
/// linearly so that the band lies inside (0, π), rows weighted by 1/σ. Numerators are eliminated response by response; what is left
/// are normal equations for A of size order·inputs, whose leading blocks are the lower orders. α₀ = I puts the poles that only fit
/// noise outside the unit circle (Cauberghe 2004), so that they come out unstable. Poles inside the band, both signs of damping.
/// The inputs are chosen by pivoted Cholesky of their weighted inner products.
std::vector<OrderPoles> polyreference_poles(const Band& band, const PolyreferenceOptions& options);

}  // namespace jointid::modalfit
