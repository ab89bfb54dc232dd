#pragma once

#include "tasks/modalfit/modal_run.hpp"
#include "report/page/contents.hpp"

namespace jointid::report {

/// Whether a pole of some order is one of the fit's modes, nearer than its decay rate or ten standard deviations.
bool is_mode(const modalfit::Mode& mode, const modalfit::CandidatePole& pole);

/// Groups of the diagram, in this order.
enum StabilisationGroup : std::size_t { at_mode, elsewhere, of_fit };

/// Poles with positive damping over frequency and order: those at a mode of the fit, the others, and above them the modes of the
/// fit; behind them mode indicators of the FRFs, of at most `most` lines. `orders`: those of the fit, or of one before.
ScatterPlot stabilisation_diagram(const tasks::ModalRun& run, const std::vector<modalfit::OrderPoles>& orders, std::size_t most);

}  // namespace jointid::report
