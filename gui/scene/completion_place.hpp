#pragma once

#include <string>

namespace jointid::gui {

/// Where in a scene's text something is being written.
struct CompletionPlace {
  enum class Kind { none, header, key, value };
  Kind kind = Kind::none;
  std::string table;   ///< path of the table: "", "joint", "joint.stiffness"
  std::string key;     ///< of a value
  std::string prefix;  ///< what is written of the word
};

/// `before`: the text up to the cursor.
CompletionPlace completion_place(const std::string& before);

/// The line (from 1) of a key in its table, of the table's header where the key is empty or not there, or 0.
int line_of_key(const std::string& text, const std::string& table, const std::string& key);

/// The lines of a table and of those below it, in the order of the text.
std::string tables_below(const std::string& text, const std::string& table);

}  // namespace jointid::gui
