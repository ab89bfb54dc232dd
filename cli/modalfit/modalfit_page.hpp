#pragma once

#include <string>

#include "cli/modalfit/modalfit_run.hpp"
#include "report/modalfit/modal_run.hpp"

namespace jointid::cli {

/// The page of a modal fit: modes, stabilisation diagram, FRFs as measured and as the model gives them, synthesis errors, MAC.
std::string modalfit_report(const report::ModalRun& run);

}  // namespace jointid::cli
