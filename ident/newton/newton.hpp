#pragma once

#include "ident/plan/method.hpp"

namespace jointid::ident {

/// Method "newton" (docs/formulas.md §7, thesis §6.12.2): the joint that predicts H_nn best, by the plan's solver.
PlannedMethod plan_newton(const Plan& plan, const StartPlanner& plan_start);

}  // namespace jointid::ident
