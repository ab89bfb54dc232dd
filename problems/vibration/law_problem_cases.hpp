#pragma once

#include <vector>

#include "problems/vibration/law_problem.hpp"

namespace jointid::problems {

LawProblem rig_two_with_ren();   ///< rig2-ren
LawProblem frame_with_joints();  ///< frame-laws
LawProblem mass_with_iwan();     ///< sdof-iwan

}  // namespace jointid::problems
