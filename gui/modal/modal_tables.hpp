#pragma once

#include "gui/plot/curve.hpp"
#include "gui/table/cell_table.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::gui {

/// MAC of every mode with every other, coloured by it.
CellRows mac_rows(const tasks::ModalRun& run);

/// Errors of synthesis of all FRFs in dB away from antiresonances, responses down, references across, coloured to 3 dB.
CellRows synthesis_rows(const tasks::ModalRun& run);

/// An FRF as measured and as the modes give it, over the lines that were fitted.
std::vector<Curve> synthesised(const tasks::ModalRun& run, std::size_t response, std::size_t reference);

}  // namespace jointid::gui
