#pragma once

#include "cli/response/response_run.hpp"

namespace jointid::cli {

/// Reads what the scene needs and computes it.
ResponseRun run_response(const ResponseScene& scene, Progress& progress);

}  // namespace jointid::cli
