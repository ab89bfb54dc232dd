#pragma once

#include "ident/plan/data_source.hpp"
#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"

namespace jointid::ident {

/// Adds to the result of a check how consistent the channels of the scene's virtual points are, in every file that has some, and
/// as suspects those that point another way than stated. Reads at most 400 lines of the measured FRFs of these channels, evenly
/// spread over the range of the scene.
void check_virtual_points(const Scene& scene, const Control& control, CheckResult& result);

}  // namespace jointid::ident
