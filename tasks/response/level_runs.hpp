#pragma once

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseResult& run);

}  // namespace jointid::tasks
