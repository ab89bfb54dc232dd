#pragma once

#include <vector>

#include "ident/check/test/screening.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// The mistakes of trials_of() made for some references of an assembly's file only: those of one day, one run or one cable, whose
/// columns leave far more than the others in the tests against the parts. None where all leave about as much.
std::vector<MistakeTrial> group_trials(const std::vector<CheckedFile>& files, const Dofs& joint,
                                       const std::vector<SpanSetup>& setups, const Screening& screening, std::size_t threads);

}  // namespace jointid::ident
