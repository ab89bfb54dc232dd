#pragma once

#include "report/response/prepared.hpp"
#include "report/response/response_run.hpp"

namespace jointid::report {

/// Every level of a scene over its frequencies: points, peak with its mode and loops, errors, stability where asked for.
void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseRun& run);

}  // namespace jointid::report
