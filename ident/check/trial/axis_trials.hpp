#pragma once

#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

/// Stretched axes: files whose FRFs at slightly other frequencies (up to 3 %) fit better. `all`: every line that was read; the
/// search itself takes some of the lines, responses and references.
std::vector<MistakeTrial> axis_trials(const std::vector<CheckedFile>& all, const Dofs& joint);

}  // namespace jointid::ident
