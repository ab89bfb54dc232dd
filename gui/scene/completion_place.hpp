#pragma once

#include <string>
#include <vector>

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

/// Tables are named by their paths, with or without the numbers of [[…]] (gui/scene/table_path.hpp).

/// The line (from 1) of a key in its table, of the table's header where the key is empty or not there, or 0.
int line_of_key(const std::string& text, const std::string& table, const std::string& key);

/// The lines of a table and of those below it, in the order of the text.
std::string tables_below(const std::string& text, const std::string& table);

/// The table in which a line (from 1) is, with the numbers of [[…]]: "joints#2.stiffness".
std::string table_at(const std::string& text, int line);

/// A table of a text, with the numbers of [[…]], and its keys; those before the first header are of "".
struct TextTable {
  std::string path;
  std::vector<std::string> keys;
};
/// All of them in the order of the text.
std::vector<TextTable> tables_in(const std::string& text);

/// The line behind the last one of a table and of those below it, comments and empty lines aside; 0 where there is none.
int behind_tables(const std::string& text, const std::string& table);

}  // namespace jointid::gui
