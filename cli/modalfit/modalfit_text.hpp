#pragma once

#include <string>

#include "cli/modalfit/modalfit_run.hpp"
#include "report/modalfit/modal_run.hpp"
#include "report/modalfit/modal_text.hpp"

namespace jointid::cli {

std::string modalfit_json(const report::ModalRun& run);
std::string modes_csv(const report::ModalRun& run);

}  // namespace jointid::cli
