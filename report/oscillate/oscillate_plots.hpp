#pragma once

#include "report/oscillate/oscillate_run.hpp"
#include "report/page/contents.hpp"

/// The plots of a report on stick–slip motion.
namespace jointid::report {

/// Velocity over displacement of each of what is seen, the first sixteen at most, with the points of its Poincaré section.
PlotGroup phase_plots(const OscillateRun& run);

/// Friction over relative velocity, and both over time.
PlotGroup contact_plots(const OscillateRun& run);

/// Proper orthogonal modes over the places where they are seen, the first six at most.
PlotGroup mode_plots(const OscillateRun& run);

/// Values over the parameter.
PlotGroup sweep_plot(const OscillateRun& run);

/// Errors over the number of coordinates, by basis.
PlotGroup reduction_plots(const ReductionTable& reduction);

}  // namespace jointid::report
