#pragma once

#include "gui/table/cell_table.hpp"
#include "tasks/bound_report.hpp"

namespace jointid::gui {

/// What measuring the candidates would do to the bounds, best first: by the mean factor, then by that of the worst unknown.
CellRows candidate_rows(const tasks::BoundReport& report);

/// The DOFs of "3:+Y, 4:+RZ". Throws InputError.
std::vector<frf::Dof> parse_dofs(const QString& text);

}  // namespace jointid::gui
