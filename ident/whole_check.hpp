#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// check_scene(). If it finds nothing and the variances of the FRFs are known, method likelihood follows on 32 to 96 lines,
/// according to their cost. It gives Solution::suspects, outlier lines, and χ² beyond ChiSquare::likely. Scenes of more than
/// 2,500 FRFs, or without such a plan, are not fitted.
CheckResult check_whole(const Scene& scene, const Control& control = {});

/// The same for FRFs in memory, in the order of the scene's [data]; its files need not exist. Virtual points are ignored: sets
/// have their coordinates already. Throws InputError for sets whose sizes do not agree (frf::validate()).
CheckResult check_whole(const Scene& scene, const std::vector<frf::FrfSet>& substructures, const std::vector<frf::FrfSet>& assembly,
                        const Control& control = {});

}  // namespace jointid::ident
