#pragma once

#include "report/response/prepared.hpp"
#include "report/response/response_run.hpp"

namespace jointid::report {

/// [[curves]], [equivalent] and [transient] of a scene, each into its part of the run; nothing where the scene has none.
void run_curves(const response::HarmonicBalance& balance, const ResponseScene& scene, const ident::Control& control, ResponseRun& run);
void run_equivalents(const ResponseScene& scene, const Prepared& prepared, ResponseRun& run);
void run_transients(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, ResponseRun& run);

}  // namespace jointid::report
