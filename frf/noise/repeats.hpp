#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Repeats of one measurement as one source. Its FRFs are the means over the runs; header().noise is variance. read_variance()
/// gives the variance of that mean from the scatter, s²/n with s² = Σ(x−x̄)²/(n−1), of the real and the imaginary part
/// separately. An FRF that some runs lack is taken from the others. With one run left its variance is NaN, with none the FRF
/// is. The noise that runs state is not used. Runs are read in parallel, block by block. Throws InputError (data) for less
/// than two runs, and for runs that differ from the first in lines (beyond axis_tolerance), DOFs (signs and order) or
/// quantity.
std::unique_ptr<FrfSource> mean_of_repeats(std::vector<std::unique_ptr<FrfSource>> runs);

}  // namespace jointid::frf
