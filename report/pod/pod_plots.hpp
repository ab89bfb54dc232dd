#pragma once

#include "oscillation/pod/pod.hpp"
#include "report/page/contents.hpp"

namespace jointid::report {

/// Proper orthogonal values over the number of the mode.
PlotGroup pod_value_plots(const oscillation::Pod& pod);

/// The modes over the channels, the first twelve at most.
PlotGroup pod_shape_plots(const oscillation::Pod& pod);

}  // namespace jointid::report
