#pragma once

#include <vector>

#include "gui/records/record_tool.hpp"

namespace jointid::gui {

/// Proper orthogonal modes; delay, dimension and exponents of one channel; the friction law of a contact; displacements from
/// strain gauges; channels that are late; FRFs of impacts or of a shaker.
std::vector<RecordTool> record_tools();

}  // namespace jointid::gui
