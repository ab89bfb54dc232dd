#pragma once

#include "gui/solve/solve_job.hpp"
#include "gui/table/cell_table.hpp"

namespace jointid::gui {

/// What the runs found beside each other: a column per run; how each was done and how well it fits, then the unknowns with half
/// their 95 % interval or their error. What a run has not is empty; an unknown is the more coloured the further it is from the
/// run in front, in parts of that.
CellRows run_rows(const std::vector<Solved>& runs, std::size_t front);

}  // namespace jointid::gui
