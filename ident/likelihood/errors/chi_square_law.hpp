#pragma once

#include "ident/likelihood/data/symmetric_frfs.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// χ² over f degrees of freedom that chance exceeds once in three million times (five standard deviations) where the joint's model is
/// right: 1 + 5√(2/f) where all variances are known. Where some are estimated from ν + 1 averages or repeats
///   e (1 + 0.02) + 5√(2/f (1 + 2/ν)),
/// e the mean of χ²/f that scatter of the variances makes: ν/(ν − 1) of those of a line alone, 1 of smoothed ones, and as much more, up
/// to 1.3 times, as FRFs there and back differ by more than their variances say; where no FRF was measured there and back e is 1.2 times
/// that. 2 at least where variances come from the scatter of the data.
double likely_chi_square(const Plan& plan, double freedom, const MirrorDifferences& differences);

}  // namespace jointid::ident
