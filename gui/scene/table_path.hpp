#pragma once

#include <map>
#include <string>
#include <utility>

namespace jointid::gui {

/// Paths of tables in a scene's text, as headers have them: "joint.stiffness", "data.files.\"a b.uff\"". Those of [[joints]] are
/// told apart by their number, from 1: "joints#2", "joints#2.stiffness".

/// A line, or part of one, without blanks at its ends.
std::string without_blanks(const std::string& text);

/// A name as a key: quoted where it is not made of letters, digits, _ and - alone.
std::string as_key(const std::string& name);

/// The table above and the last key; the former is empty at the top.
std::pair<std::string, std::string> parted(const std::string& path);

/// As the header of a path is written: "[joints.stiffness]", "[[joints]]".
std::string header_of(const std::string& path);

/// The path up to its last number, "joints#2" of "joints#2.stiffness"; empty where there is none.
std::string numbered_part(const std::string& path);

/// Follows the headers of a text.
class TablePath {
 public:
  /// Takes a line that is no part of a value over several lines; false where it is no header.
  bool take(const std::string& line);

  /// As in the header, names quoted where they have to be.
  const std::string& plain() const { return plain_; }
  /// The same with the numbers of [[…]].
  const std::string& numbered() const { return numbered_; }
  bool is(const std::string& path) const { return plain_ == path || numbered_ == path; }
  bool is_in(const std::string& path) const;

 private:
  std::string plain_, numbered_;
  std::map<std::string, int> arrays_;  ///< how many of each there were
};

}  // namespace jointid::gui
