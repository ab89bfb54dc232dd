#pragma once

#include "study/measurements.hpp"

namespace jointid::study {

/// Regenerates what the scene names after the errors of each trial have been put on it.
Pollution with_regeneration(Pollution pollution, const ident::Scene& scene);

/// Sets that will be regenerated carry variances.
void declare_regeneration(TrialData& data);

}  // namespace jointid::study
