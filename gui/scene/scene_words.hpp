#pragma once

#include <string>
#include <vector>

namespace jointid::gui {

/// The keys that the scene reader takes in a table, asked of the reader itself: it is given a key that is none, and names all
/// that are. Empty for a table that it does not know, or in which any key will do.
std::vector<std::string> keys_of(const std::string& table);

/// The words that the reader takes as value of a key (or as elements of its list), or none where it takes anything else.
std::vector<std::string> words_of(const std::string& table, const std::string& key);

/// What the reader takes as value of a key.
enum class ValueKind {
  value,  ///< anything else: lists of lists, tables
  text,   ///< a string
  number,
  flag,      ///< true or false
  word,      ///< one of words_of()
  interval,  ///< [lo, hi]
  words,     ///< a list of words_of()
  texts,     ///< a list of strings
  dofs,      ///< a list of DOFs
  files,     ///< a list of files of [data]
};

/// Asked of the reader, too: it is given a date, which it takes nowhere, and says what it expects instead.
ValueKind kind_of(const std::string& table, const std::string& key);

/// All of these beforehand, by another thread than the window's: what was asked once is kept.
void ask_for_everything();

/// Whether a scene may have several of a table, as [[data.gains]].
bool is_of_several(const std::string& table);

/// The paths of all tables, "data", "joint.stiffness", …; "data.files.*" is that of any file.
std::vector<std::string> all_tables();

}  // namespace jointid::gui
