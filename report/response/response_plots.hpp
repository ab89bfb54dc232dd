#pragma once

#include "report/page/contents.hpp"
#include "tasks/response/response_result.hpp"

/// The plots of `jointid response`. Groups without anything to draw are empty.
namespace jointid::report {

/// |X|/force of the lowest harmonic and its phase, all levels together, one choice per response.
PlotGroup level_plots(const tasks::ResponseResult& run);

/// |X_n| of the first response, all harmonics together, one choice per level.
PlotGroup harmonic_plots(const tasks::ResponseResult& run);

/// Frequency and damping of the peaks over the force.
PlotGroup backbone_plots(const tasks::ResponseResult& run);

/// Force over displacement at the peaks, one choice per joint.
PlotGroup loop_plots(const tasks::ResponseResult& run);

/// |X| along [[curves]], turning points and peaks marked.
PlotGroup curve_plots(const tasks::ResponseResult& run);

/// k_e and d_e over amplitude, and the mode with them.
PlotGroup equivalent_plots(const tasks::ResponseResult& run);

/// |X|/force of the peak over the normal load of [clamping], all levels together.
PlotGroup clamping_plots(const tasks::ResponseResult& run);

/// Motions of [transient] over time, and loops of the joints.
PlotGroup transient_plots(const tasks::ResponseResult& run);

}  // namespace jointid::report
