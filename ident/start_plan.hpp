#pragma once

#include <utility>

#include "ident/plan.hpp"

namespace jointid::ident {

/// Plans the linear estimate that an iterative method starts from: the first of these methods and equations that the data allow.
/// Throws InputError where they allow none.
std::unique_ptr<Plan> plan_start(const Plan& plan, const std::vector<std::pair<Method, std::vector<Equation>>>& choices);

}  // namespace jointid::ident
