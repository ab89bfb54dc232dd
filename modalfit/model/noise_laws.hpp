#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// For a band whose noise nobody told: from what neighbouring lines of an entry do not share. Second differences d of what a model
/// leaves, |d|²/12, observe the variance a|H|² + b|c|² of real and of imaginary part alike, H the fitted value, c the factor from the
/// stored quantity to receptance (a floor of the transducer). What varies slowly from line to line, as does what the model misses, drops
/// out; squares above ten times their variance, as of a peak that the model lacks, count as ten times. a, b ≥ 0 by maximum
/// likelihood at places about 400 lines apart, linear between them. Noise that neighbouring lines share scales the
/// law at each place by 1/4 to 6, as the residuals themselves (bounded alike) ask for. Sets the weights of the entries.
void estimate_noise(Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles);

}  // namespace jointid::modalfit
