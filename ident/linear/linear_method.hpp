#pragma once

#include "ident/plan/method.hpp"

namespace jointid::ident {

/// Plan Method One, Method Two and the direct solution (make_method_one() and so on say what they are).
std::unique_ptr<MethodPlan> plan_method_one(Plan& plan);
std::unique_ptr<MethodPlan> plan_method_two(Plan& plan);
std::unique_ptr<MethodPlan> plan_direct(Plan& plan);

}  // namespace jointid::ident
