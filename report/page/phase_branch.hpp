#pragma once

#include "report/page/contents.hpp"

namespace jointid::report {

/// Moves all phases into the period that they cross least (report/phase_branch.hpp), sets the plot's y-range to it, and draws what
/// crosses its end all the same again and again, as noise does, as points.
void choose_branch(CurvePlot& phases);

}  // namespace jointid::report
