#pragma once

#include "ident/plan/method.hpp"

namespace jointid::ident {

/// Plan Method One, Method Two and the direct solution (make_method_one() and so on say what they are).
PlannedMethod plan_method_one(const Plan& plan);
PlannedMethod plan_method_two(const Plan& plan);
PlannedMethod plan_direct(const Plan& plan);

}  // namespace jointid::ident
