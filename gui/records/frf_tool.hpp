#pragma once

#include "gui/records/record_tool.hpp"

namespace jointid::gui {

/// `jointid frf`: FRFs of impacts of a hammer, or of the segments of a long record.
RecordTool frf_tool();

}  // namespace jointid::gui
