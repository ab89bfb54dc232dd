#pragma once

#include "report/response/response_run.hpp"

namespace jointid::report {

/// Reads what the scene needs and computes it.
ResponseRun run_response(const ResponseScene& scene, const ident::Control& control);

}  // namespace jointid::report
