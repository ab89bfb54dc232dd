#pragma once

#include "study/measurements.hpp"

namespace jointid::problems {

/// Adds a floor to every FRF of a trial: a complex normal error whose standard deviation is `share` times the median modulus of
/// that FRF over all lines of `clean`, in the stored quantity. The sets of `data` have DOFs and lines of it. H_ij and H_ji share
/// it. The rms would be made by the resonances of lightly damped beams.
void add_median_floor(study::Measurements& data, const study::Measurements& clean, double share, std::uint64_t seed,
                      std::uint64_t trial);

}  // namespace jointid::problems
