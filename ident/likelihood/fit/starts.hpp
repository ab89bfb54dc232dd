#pragma once

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// Whether H_jn of the assembly is measured.
bool joint_is_reached(const Plan& plan);

/// Whether a part is a model with an error.
bool has_scales(const Plan& plan);

/// Where the iteration begins: from the scene's start, from springs, or from linear estimates. `estimator` tells how well they
/// fit. Models with an error are as they state in the first, and as much softer and stiffer as one and two of their deviations in
/// the next: a resonance that is off by more than its width hides the way to the right scale. It and `plan` outlive what is
/// returned.
Starts starts_of(const Plan& plan, LikelihoodEstimator& estimator, const Control& control);

}  // namespace jointid::ident
