#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Repeats of one measurement as one source. It hands out the mean over the runs, header().noise is variance, and
/// read_variance() gives the variance of that mean from the scatter, s²/n with s² = Σ(x−x̄)²/(n−1), of the real and the
/// imaginary part apart. An FRF that some runs lack is taken from the others; with one run left its variance is NaN, with none
/// the FRF is. What the runs say of their own noise is not used. Runs are read side by side, block by block.
/// Throws InputError (data) for less than two runs, and for runs that differ from the first in frequency lines (beyond
/// axis_tolerance), DOFs (with their signs and order) or quantity.
std::unique_ptr<FrfSource> mean_of_repeats(std::vector<std::unique_ptr<FrfSource>> runs);

}  // namespace jointid::frf
