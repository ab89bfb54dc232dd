#pragma once

#include <optional>
#include <vector>

#include "cli/report/contents.hpp"

namespace jointid::cli::report {

/// Upper end, in degrees, of the period of 360° in which curves of phases are drawn: of the multiples of 15° that which the curves
/// cross least, 180° where it is as good. At ±180° the phase of a lightly damped structure stays, and its noise crosses.
double branch_end_deg(const std::vector<Series>& phases);

/// How often the curve crosses `end` (a neighbour is taken the shorter way around the circle).
std::size_t crossings(const std::vector<double>& phase_deg, double end_deg);

/// Moves all phases into one period, sets the plot's y-range to it, and draws what crosses its end all the same again and again,
/// as noise does, as points.
void choose_branch(CurvePlot& phases);

}  // namespace jointid::cli::report
