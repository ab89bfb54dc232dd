#pragma once

#include <string>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// The solution as JSON with the keys status, message, unknowns, matrices, dofs, fit, quality, runtime_s and used. What was
/// not computed and what is not finite is null. With several frequency bands `matrices` is null and `bands` lists them.
std::string solution_json(const ident::Solution& solution);

}  // namespace jointid::report
