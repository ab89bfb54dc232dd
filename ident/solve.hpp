#pragma once

#include "ident/plan.hpp"
#include "ident/solution.hpp"

namespace jointid::ident {

/// Carries out a plan: reads what it names line by line, assembles, solves, and judges the result. Throws InputError when
/// the data break their promises; a numerical outcome is Solution::status.
Solution solve(Plan& plan);

}  // namespace jointid::ident
