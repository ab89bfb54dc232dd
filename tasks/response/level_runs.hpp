#pragma once

#include <functional>
#include <vector>

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// The points of one force level over the scene's frequencies, by its method, and the peak. `advance` is called before each point of a
/// sweep with those so far, and may throw; `begun` are the first of these.
LevelResponse level_response(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                             double amplitude,
                             const std::function<void(const std::vector<response::HarmonicSolution>&)>& advance = {},
                             std::vector<response::HarmonicSolution> begun = {});

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for. Levels
/// that `run` has already are the first of the scene's, and are left as they are; `begun` are the first points of the next. `keep` gets
/// what there is before each point and after each level.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseResult& run,
                std::vector<response::HarmonicSolution> begun = {}, const KeepLevels& keep = {});

}  // namespace jointid::tasks
