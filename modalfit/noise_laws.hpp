#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band.hpp"
#include "modalfit/model_kind.hpp"
#include "modalfit/pole.hpp"

namespace jointid::modalfit {

/// For a band whose noise nobody told: what a fit leaves of an entry is taken for noise with the variance a|H|² + b|c|² of real and
/// of imaginary part alike, H the fitted value, c the factor from the stored quantity to receptance (a floor of the transducer).
/// a, b ≥ 0 by maximum likelihood of the residuals, whose loss of freedom to the fit is made good. Sets the weights of the entries.
void estimate_noise(Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles);

}  // namespace jointid::modalfit
