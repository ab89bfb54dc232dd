#pragma once

#include <string>
#include <vector>

namespace jointid::report {

/// A line "note: …" for each, whose control characters are shown.
std::string notes_text(const std::vector<std::string>& notes);

}  // namespace jointid::report
