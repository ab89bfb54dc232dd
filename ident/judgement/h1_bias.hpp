#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// By how much H1 may be too low, relative: 1 − γ² of the middle one of the FRFs of up to 16 lines, of the file where that is
/// largest. Noise of the force makes it so low, noise of the responses alone does not: coherences leave open which it is. 0 where
/// variances do not come from coherences, or FRFs are synthesised.
double h1_bias(const Plan& plan);

}  // namespace jointid::ident
