#pragma once

#include <string>

#include "cli/modalfit/modalfit_run.hpp"

namespace jointid::cli::report {

/// The page of a modal fit: modes, stabilisation diagram, FRFs as measured and as the model gives them, synthesis errors, MAC.
std::string modalfit_report(const ModalRun& run);

}  // namespace jointid::cli::report
