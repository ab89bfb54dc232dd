#pragma once

#include "report/page/contents.hpp"
#include "report/text/display.hpp"
#include "tasks/convergence.hpp"
#include "tasks/regenerate.hpp"

/// The plots of a solve report.
namespace jointid::report {

/// Magnitude, difference in dB and phase of measured and regenerated FRFs, one choice per FRF that was measured; `used_hz`: a
/// range to shade, that of the lines that the joint was identified from. At most `most` points per FRF, peaks kept. Of receptances
/// in SI units; shown in the quantity and units of `display`.
PlotGroup frf_overlay(const tasks::Regenerated& receptances, std::optional<std::array<double, 2>> used_hz, std::size_t most,
                      const Display& display = {});

/// RJCF and ARVF of each matrix against the number of lines (docs/formulas.md §6).
PlotGroup quality_plots(const std::vector<tasks::LineQuality>& lines);

/// The objective of an iterative method, and its unknowns over those of the solution, both over the iterations: a choice for
/// every eight unknowns, those that moved most first, at most five choices. None of less than two steps.
PlotGroup iteration_plots(const tasks::UnknownsByIteration& found);

}  // namespace jointid::report
