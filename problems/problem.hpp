#pragma once

#include <string>
#include <vector>

#include "problems/case/identification_problem.hpp"
#include "problems/case/problem_info.hpp"

namespace jointid::problems {

/// All built-in problems in the order of the thesis.
std::vector<ProblemInfo> list();

/// Builds one; throws InputError (usage) with the nearest name when there is none.
Problem make(const std::string& name);

}  // namespace jointid::problems
