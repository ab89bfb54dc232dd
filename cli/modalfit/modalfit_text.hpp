#pragma once

#include <string>

#include "cli/modalfit/modalfit_run.hpp"
#include "cli/text/table.hpp"
#include "report/modalfit/modal_text.hpp"

namespace jointid::cli {

using jointid::report::model_text;
using jointid::report::synthesis_text;

std::string modalfit_json(const ModalRun& run);
std::string modes_csv(const ModalRun& run);

}  // namespace jointid::cli
