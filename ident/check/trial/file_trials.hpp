#pragma once

#include <vector>

#include "ident/check/test/misfit.hpp"
#include "ident/check/test/screening.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// Of whole files: units, delays, quantities, signs, conjugates, masses of sensors.
std::vector<MistakeTrial> file_trials(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                      const Screening& screening, const Misfit& misfit);

/// Files of the substructures that hold each other's FRFs.
std::vector<MistakeTrial> exchange_trials(const std::vector<CheckedFile>& files);

}  // namespace jointid::ident
