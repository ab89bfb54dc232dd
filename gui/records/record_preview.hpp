#pragma once

#include <filesystem>
#include <functional>

#include "report/page/contents.hpp"

namespace jointid::gui {

/// A record as it was measured: its channels over time, or over the number of the sample where the file has no times; four below
/// each other. Of long records the first 262,144 samples. Throws InputError, and Interrupted.
report::PlotGroup record_preview(const std::filesystem::path& file, const std::function<bool()>& interrupted);

}  // namespace jointid::gui
