#pragma once

#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// check_scene(), and where that finds nothing and the variances of the FRFs are known, what method likelihood says of 32 to 96 lines,
/// by what they cost: Solution::suspects, lines that it sets aside, and χ² beyond ChiSquare::likely. Scenes of more than 2,500 FRFs, or
/// that have no such plan, are not fitted.
CheckResult check_whole(const Scene& scene, const Control& control = {});

}  // namespace jointid::ident
