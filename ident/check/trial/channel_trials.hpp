#pragma once

#include <vector>

#include "ident/check/test/screening.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// Signs and labels of the channels that the tests would rather be without.
std::vector<MistakeTrial> channel_trials(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                         const Screening& screening);

}  // namespace jointid::ident
