#pragma once

#include <string>
#include <vector>

#include "laws/data/level_states.hpp"
#include "response/identify/consistency.hpp"

namespace jointid::laws {

/// "response 11:+Y times -1 (its sign is wrong: key flip)", "the forces of 12 N times 1.4 …", "responses 3:+Y and 5:+Y exchanged …".
std::string fault_text(const response::DataFault& fault, const std::vector<frf::Dof>& responses, const std::vector<std::string>& levels);

/// What a test that they do not pass says of the data: χ², and the mistakes that would explain it.
std::string contradiction_text(const response::Consistency& test, const std::vector<frf::Dof>& responses,
                               const std::vector<std::string>& levels);

}  // namespace jointid::laws
