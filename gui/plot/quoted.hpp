#pragma once

#include <string>

namespace jointid::gui {

/// A text as a cell of a table that is parted by commas or tabs.
inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace jointid::gui
