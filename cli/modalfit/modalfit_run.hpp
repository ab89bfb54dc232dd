#pragma once

#include "cli/modalfit/modalfit_arguments.hpp"
#include "report/modalfit/modal_run.hpp"

namespace jointid::cli {

using jointid::report::ModalRun;
using jointid::report::Shapes;

/// Reads the files and fits. Throws InputError.
ModalRun run_modalfit(const ModalfitArguments& arguments);

}  // namespace jointid::cli
