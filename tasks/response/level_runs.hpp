#pragma once

#include <functional>
#include <vector>

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for. Levels
/// that `run` has already are the first of the scene's, and are left as they are. `finished` gets all so far after each.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseResult& run,
                const std::function<void(const std::vector<LevelResponse>&)>& finished = {});

}  // namespace jointid::tasks
