#pragma once

#include <vector>

#include "ident/check/test/screening.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// Gains of channels, by their rows of span tests and by H_ij against H_ji.
std::vector<MistakeTrial> gain_trials(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                      const Screening& screening);

}  // namespace jointid::ident
