#pragma once

#include <vector>

#include "frf/noise/noise.hpp"
#include "frf/set/excerpt.hpp"
#include "study/measurements.hpp"
#include "study/systematic_noise.hpp"

namespace jointid::study {

/// What the plan reads of every set, clean.
struct Excerpts {
  std::vector<frf::Excerpt> substructures, assembly;
};

/// Errors of gains and masses, then the noise of `model`; of sets that are models the noise that these record.
Pollution pollution_of(const Excerpts& excerpts, const frf::NoiseModel& model, const SystematicNoise& systematic);

/// Errors by the variances and covariances that the sets record.
Pollution recorded_pollution(const Excerpts& excerpts);

}  // namespace jointid::study
