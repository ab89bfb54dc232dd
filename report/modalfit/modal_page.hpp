#pragma once

#include <string>

#include "tasks/modalfit/modal_run.hpp"

namespace jointid::report {

/// The page of a modal fit: modes, stabilisation diagram, FRFs as measured and as the model gives them, synthesis errors, MAC.
std::string modal_page(const tasks::ModalRun& run);

}  // namespace jointid::report
