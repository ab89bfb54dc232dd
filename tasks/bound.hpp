#pragma once

#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::tasks {

/// Cramér–Rao bound (docs/formulas.md §11g): the smallest standard deviation of any unbiased estimate of each unknown, for the
/// data of a plan with method "likelihood" and the joint `values` (SI, one per column of the plan). Infinite for unknowns that
/// the data do not determine. On exact or model FRFs it is a prediction, on measured ones an estimate.
std::vector<double> cramer_rao_bound(const ident::Plan& plan, const std::vector<double>& values, const ident::Control& control);

}  // namespace jointid::tasks
