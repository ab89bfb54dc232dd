#pragma once

#include "tasks/response/prepared.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// [[curves]], [equivalent] and [transient] of a scene, each into its part of the run; nothing where the scene has none.
void run_curves(const response::HarmonicBalance& balance, const ResponseScene& scene, const ident::Control& control,
                ResponseResult& run);
void run_equivalents(const ResponseScene& scene, const Prepared& prepared, ResponseResult& run);
void run_transients(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, ResponseResult& run);

}  // namespace jointid::tasks
