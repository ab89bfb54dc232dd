#pragma once

#include "cli/modalfit/modalfit_arguments.hpp"
#include "report/modalfit/modal_run.hpp"

namespace jointid::cli {

/// Reads the files and fits. Throws InputError.
report::ModalRun run_modalfit(const ModalfitArguments& arguments);

}  // namespace jointid::cli
