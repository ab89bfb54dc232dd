#pragma once

#include "report/text/table.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::report {

/// The peak of each level: frequency, size, damping of its mode, loss, stability.
Table peaks_table(const tasks::ResponseResult& run);

/// All points of all levels.
Table points_table(const tasks::ResponseResult& run);

/// At most `most` points of a curve, evenly chosen, and its peaks.
Table curve_table(const tasks::CurveRun& curve, const tasks::ResponseResult& run, std::size_t most);

/// ", 2 N at 50 Hz": what does not change.
std::string curve_remark(const tasks::CurveRun& curve);

/// k_e and d_e of each joint over amplitude, and the mode with them.
Table equivalents_table(const tasks::ResponseResult& run);

/// The peak over each normal load of [clamping], those tried on the way to the best among them.
Table clamping_table(const tasks::ClampingRun& clamping);

/// "1 N: least under 2.31 of the normal load …"; why there is none.
std::string clamping_verdict(const tasks::ClampingRun& clamping);

/// Largest motions and forces of each transient.
Table transients_table(const tasks::ResponseResult& run);

}  // namespace jointid::report
