#pragma once

#include "report/response/response_run.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// The peak of each level: frequency, size, damping of its mode, loss, stability.
Table peaks_table(const ResponseRun& run);

/// All points of all levels.
Table points_table(const ResponseRun& run);

/// At most `most` points of a curve, evenly chosen, and its peaks.
Table curve_table(const CurveRun& curve, const ResponseRun& run, std::size_t most);

/// ", 2 N at 50 Hz": what does not change.
std::string curve_remark(const CurveRun& curve);

/// k_e and d_e of each joint over amplitude, and the mode with them.
Table equivalents_table(const ResponseRun& run);

/// Largest motions and forces of each transient.
Table transients_table(const ResponseRun& run);

}  // namespace jointid::report
