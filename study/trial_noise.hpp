#pragma once

#include "frf/noise/noise.hpp"
#include "study/measurements.hpp"

namespace jointid::study {

/// Makes base data and scene say the noise that the trials will have, not that of the files they came from: sets of a hammer
/// test carry its coherences and averages, others nothing, so that their variances come from the law of the model, which
/// becomes the scene's [noise].
void declare_noise(const frf::NoiseModel& model, TrialData& data);

}  // namespace jointid::study
