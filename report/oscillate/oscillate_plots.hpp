#pragma once

#include "report/page/contents.hpp"
#include "tasks/oscillate/oscillate_result.hpp"

/// The plots of a report on stick–slip motion.
namespace jointid::report {

/// Velocity over displacement of each of what is seen, the first sixteen at most, with the points of its Poincaré section.
PlotGroup phase_plots(const tasks::OscillateResult& run);

/// Friction over relative velocity, and both over time.
PlotGroup contact_plots(const tasks::OscillateResult& run);

/// Proper orthogonal modes over the places where they are seen, the first six at most.
PlotGroup mode_plots(const tasks::OscillateResult& run);

/// Values over the parameter.
PlotGroup sweep_plot(const tasks::OscillateResult& run);

/// Errors over the number of coordinates, by basis.
PlotGroup reduction_plots(const tasks::ReductionTable& reduction);

}  // namespace jointid::report
