#pragma once

#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Of all joints whose two sides the assembly's files have; empty where they do not state its errors. Rows by parts see a stiff joint
/// through this difference alone, and no condition number shows what it loses there.
std::vector<RelativeMotion> relative_motions(const Plan& plan);

/// Fills Solution::relative_motions, and warns of those that are not above their errors.
void tell_relative_motions(const Plan& plan, Solution& out);

}  // namespace jointid::ident
