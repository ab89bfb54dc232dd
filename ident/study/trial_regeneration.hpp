#pragma once

#include "ident/study/measurements.hpp"

namespace jointid::ident {

/// Regenerates what the scene names after the errors of each trial have been put on it.
Pollution with_regeneration(Pollution pollution, const Scene& scene);

/// Sets that will be regenerated carry variances.
void declare_regeneration(TrialData& data);

}  // namespace jointid::ident
