#pragma once

#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// check_scene(), and where that finds nothing and the variances of the FRFs are known, what method likelihood leaves of up to 24
/// lines: a joint of this scene that does not explain them is a suspect, too. Scenes of more than 2,500 FRFs, or that have no
/// such plan, are not fitted.
CheckResult check_whole(const Scene& scene, const Control& control = {});

}  // namespace jointid::ident
