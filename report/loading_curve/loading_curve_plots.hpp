#pragma once

#include "report/page/contents.hpp"
#include "tasks/loading_curve/loading_curve_result.hpp"

/// The plots of a report on loading curves.
namespace jointid::report {

/// Measured curves with those of all laws, and their residuals where a law was fitted; one choice per curve, at most `most` of
/// them, evenly chosen.
PlotGroup curves_and_residuals(const tasks::LoadingCurveResult& result, std::size_t most);

/// u(h): displacement at which the share h of the stiffness slips, by law (docs/formulas.md §10a, 2.53).
PlotGroup slip_distribution(const tasks::LoadingCurveResult& result);

/// k_e, d_e and energy per cycle over amplitude, by law; measured energies of loops as points of their own.
PlotGroup equivalents_plots(const tasks::LoadingCurveResult& result);

/// Limit and stiffness of every loop, in turn; empty without several loops.
PlotGroup loops_in_turn(const tasks::LoadingCurveResult& result);

}  // namespace jointid::report
