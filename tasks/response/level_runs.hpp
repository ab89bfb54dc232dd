#pragma once

#include <vector>

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for. Levels
/// that `run` has already are the first of the scene's, and are left as they are; `begun` are the first points of the next. `keep` gets
/// what there is before each point and after each level.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseResult& run,
                std::vector<response::HarmonicSolution> begun = {}, const KeepLevels& keep = {});

}  // namespace jointid::tasks
