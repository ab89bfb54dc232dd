#pragma once

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// Whether H_jn of the assembly is measured.
bool joint_is_reached(const Plan& plan);

/// Where the iteration begins: from the scene's start, from springs, or from linear estimates. `estimator` tells how well they fit.
/// It and `plan` outlive what is returned.
Starts starts_of(const Plan& plan, LikelihoodEstimator& estimator, const Control& control);

}  // namespace jointid::ident
