#pragma once

#include "report/page/contents.hpp"
#include "series/pod/pod.hpp"

namespace jointid::report {

/// Proper orthogonal values over the number of the mode.
PlotGroup pod_value_plots(const series::Pod& pod);

/// The modes over the channels, the first twelve at most.
PlotGroup pod_shape_plots(const series::Pod& pod);

}  // namespace jointid::report
