#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/poles/refine.hpp"

namespace jointid::modalfit {

/// How far the poles of the FRFs scatter about the common ones.
struct PoleScatter {
  /// [2N] factor ≥ 1 on the standard deviation of (ln f_1, damping_1, …) by the inverse Fisher information.
  std::vector<double> factor;
  std::vector<std::array<double, 2>> own_hz;  ///< [N] lowest and highest frequency of the FRFs that tell it, each by its own
};

/// What the inverse Fisher information C leaves out. With g_e the gradient of FRF e and I_e its diagonal information, per
/// parameter the larger of
///   - the mean square of the residuals over their variances, lines weighted by their share in the information;
///   - the variance by the scatter of the gradients, n/(n−1) Σ_g (C g)² over groups g of FRFs (each alone; those of one response;
///   those of
///     one reference), n = (ΣI_g)²/ΣI_g² the groups that count, over the diagonal of C. Hammer points that were measured one
///     after the other have frequencies of their own (temperature, suspension, accelerometer), which lines of one FRF do not
///     show.
PoleScatter pole_scatter(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& refined);

/// Multiplies row and column i of a [n,n] covariance by factor i.
void widen(std::vector<double>& covariance, const std::vector<double>& factor);

}  // namespace jointid::modalfit
