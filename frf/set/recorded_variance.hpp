#pragma once

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Whether a set says how exact it is: by variances, or by coherences of more than one average.
bool knows_noise(const FrfSet& set);

/// Variances of real and imaginary part of value `at` of a set that knows its noise.
Complex recorded_variance(const FrfSet& set, std::size_t at);

}  // namespace jointid::frf
