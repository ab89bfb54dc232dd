#pragma once

#include <string>

#include "report/response/response_run.hpp"

namespace jointid::report {

/// The page of `jointid response`: FRFs of all levels, harmonics, peaks over level, loops, curves, equivalent joints, transients.
std::string response_report(const ResponseScene& scene, const ResponseRun& run);

}  // namespace jointid::report
