#pragma once

#include <utility>

#include "report/page/contents.hpp"
#include "study/comparison.hpp"

/// The plots of a comparison report.
namespace jointid::report {

/// Time in ms and median rms error of the judged matrix: where error_against_time() has the combination.
std::pair<double, double> point_of(const study::Combination& combination, std::size_t matrix);

/// Error of the judged matrix number `matrix` against run time, one point per combination that gave an estimate, and the Pareto
/// front. Points are named by what differs between the combinations, and coloured by the first of weighting, method, equations,
/// Δ and solver that does.
ScatterPlot error_against_time(const std::vector<study::Combination>& combinations, std::size_t matrix);

}  // namespace jointid::report
