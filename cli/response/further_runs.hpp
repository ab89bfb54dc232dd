#pragma once

#include "cli/response/prepared.hpp"
#include "cli/response/response_run.hpp"

namespace jointid::cli {

/// [[curves]], [equivalent] and [transient] of a scene, each into its part of the run; nothing where the scene has none.
void run_curves(const response::HarmonicBalance& balance, const ResponseScene& scene, Progress& progress, ResponseRun& run);
void run_equivalents(const ResponseScene& scene, const Prepared& prepared, ResponseRun& run);
void run_transients(const ResponseScene& scene, const Prepared& prepared, Progress& progress, ResponseRun& run);

}  // namespace jointid::cli
