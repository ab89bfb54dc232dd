#pragma once

#include "ident/plan/method.hpp"

namespace jointid::ident {

/// Method "likelihood": reads, starts from the linear estimate or the scene's, fits, and fills a solution with unknowns, standard
/// errors and 95 % intervals from the Cramér–Rao covariance, matrices, χ² and figures of merit.
PlannedMethod plan_likelihood(const Plan& plan, const StartPlanner& plan_start);

}  // namespace jointid::ident
