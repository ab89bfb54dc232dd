#pragma once

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// [clamping] of a scene at each of its force levels: peaks of the response over normal loads, and the load of the least, to 1 %.
/// Nothing where the scene has none.
void run_clamping(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, ResponseResult& run);

}  // namespace jointid::tasks
