#pragma once

#include "gui/table/cell_table.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"
#include "tasks/bound_report.hpp"

namespace jointid::gui {

/// What solving reads, computes and leaves out.
CellRows plan_rows(const ident::Plan& plan);

/// The smallest standard errors that the data allow, and what other data would make of them.
CellRows bound_rows(const tasks::BoundReport& report);

/// Unknowns with value, unit, 95 % interval or error estimate, and a bar on a scale of its unit.
CellRows unknown_rows(const ident::Solution& solution);

/// A joint matrix, coloured by size and sign, blank where an element is zero and no unknown; ± half the 95 % interval of
/// the unknown that an element is, or the error estimate, where known.
CellRows matrix_rows(const ident::Solution& solution, std::size_t band, restrictions::Kind kind);

/// Message, warnings, findings, suspects, fit and quality: one sentence each.
CellRows finding_rows(const ident::Solution& solution);

}  // namespace jointid::gui
