#pragma once

#include "cli/response/prepared.hpp"
#include "cli/response/response_run.hpp"

namespace jointid::cli {

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                Progress& progress, ResponseRun& run);

}  // namespace jointid::cli
