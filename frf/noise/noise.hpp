#pragma once

#include <cstdint>

#include "frf/noise/noise_model.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// `clean` with noise; NaN entries stay NaN. Entry i draws from the counter i of stream (seed, trial, set),
/// so the noise of an entry depends neither on the other entries nor on threads. Sets of one trial need
/// different `set` numbers.
FrfSet polluted(const FrfSet& clean, const NoiseModel& model, std::uint64_t seed, std::uint64_t trial,
                std::uint64_t set = 0);

}  // namespace jointid::frf
