#pragma once

#include <string>
#include <vector>

#include "problems/case/problem_info.hpp"
#include "problems/vibration/law_problem.hpp"

namespace jointid::problems {

LawProblem frame_with_joints();  ///< frame-laws
LawProblem mass_with_iwan();     ///< sdof-iwan
LawProblem rig_two_with_ren();   ///< rig2-laws

std::vector<ProblemInfo> list_law_problems();
bool is_law_problem(const std::string& name);

/// Throws InputError (usage) with the nearest name when there is none.
LawProblem make_law_problem(const std::string& name);

}  // namespace jointid::problems
