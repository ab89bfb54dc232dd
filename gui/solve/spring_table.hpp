#pragma once

#include "gui/table/cell_table.hpp"
#include "ident/result/solution.hpp"

namespace jointid::gui {

/// The springs of a joint, one by one: stiffness k and loss factor η = D/k with their intervals, and a bar of k on the scale of all
/// springs along the same direction, so that a loose bolt is seen. The interval of η is the widest that those of k and D allow. No rows for
/// joints of other unknowns.
CellRows spring_rows(const ident::Solution& solution);

}  // namespace jointid::gui
