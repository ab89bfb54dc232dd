#pragma once

#include <ostream>
#include <string>

namespace jointid::cli {

/// Writes to `out` when the target is "-", else to the file of that name, whole or not at all.
void write_target(const std::string& target, const std::string& text, std::ostream& out);

}  // namespace jointid::cli
