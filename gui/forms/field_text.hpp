#pragma once

#include <string>

#include "gui/scene/scene_words.hpp"

namespace jointid::gui {

/// What a field of the form shows of a value, and whether it can be edited there: a value with comments inside is left to the
/// text.
struct ShownValue {
  std::string text;
  bool is_locked = false;
};

/// Strings without quotes, lists of strings with commas, all else as TOML in one line. `value`: as written, "" where the key is
/// not there.
ShownValue shown_value(ValueKind kind, const std::string& value);

/// What a value is by how it is written: a text, a flag, a list of texts or anything else.
ValueKind kind_as_written(const std::string& value);

/// The TOML of what was written into a field: "" for an empty one; what begins with a quote or bracket is taken as TOML.
std::string written_value(ValueKind kind, const std::string& shown);

/// Cells of a spreadsheet (tabs and lines) as a field takes them: names of a list with commas, all else as rows of a matrix, in
/// which words are strings.
std::string pasted_cells(ValueKind kind, const std::string& cells);

}  // namespace jointid::gui
