#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace jointid::gui {

/// Tables are named by their paths (gui/scene/table_path.hpp).

/// The value of a key as it is written, over several lines perhaps; empty where the key is not there. A table that stands as the
/// value of a key (`start = { … }`) is a value of the table above it.
std::optional<std::string> value_of(const std::string& text, const std::string& table, const std::string& key);

/// The first and last line (from 1) of `key = value`.
std::optional<std::array<int, 2>> lines_of(const std::string& text, const std::string& table, const std::string& key);

/// The text with `key = value` in a table: the value of the key is replaced, comments and all else stay; a key that is not there
/// goes to the end of its table, a table that is not there to the end of the text.
std::string with_value(const std::string& text, const std::string& table, const std::string& key, const std::string& value);

/// The text without a key; a comment behind it stays, a table without anything in it goes, too.
std::string without_value(const std::string& text, const std::string& table, const std::string& key);

/// The strings in a value, whatever lists they are in.
std::vector<std::string> strings_in(const std::string& value);

/// Where a line (from 1) begins; the end of the text where there is none.
std::size_t begin_of_line(const std::string& text, int number);

}  // namespace jointid::gui
