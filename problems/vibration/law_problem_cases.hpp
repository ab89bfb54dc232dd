#pragma once

#include <vector>

#include "problems/vibration/law_problem.hpp"

namespace jointid::problems {

LawProblem frame_with_joints();  ///< frame-laws
LawProblem mass_with_iwan();     ///< sdof-iwan

}  // namespace jointid::problems
