#pragma once

#include <filesystem>

#include "gui/plot/heat_chart.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::gui {

/// The modes of a fit beside those of another set, over the coordinates that both have.
struct CrossMac {
  HeatPlot map;  ///< a row for each mode of the fit, a column for each of the other set
  QString said;  ///< how many pairs, over how many coordinates
};

/// The other set is a file of tasks::read_modes(), of a test or of a model. Throws InputError, also where no coordinate is
/// common.
CrossMac cross_mac(const tasks::ModalRun& run, const std::filesystem::path& other);

}  // namespace jointid::gui
