#pragma once

#include <vector>

#include "ident/check/test/misfit.hpp"
#include "ident/check/test/screening.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// The mistakes that are worth a trial; none where nothing stands out.
std::vector<MistakeTrial> trials_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                    const Screening& screening, const Misfit& misfit);

}  // namespace jointid::ident
