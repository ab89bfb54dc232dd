#pragma once

#include <istream>
#include <string>
#include <vector>

namespace jointid::structure {

struct FunctionLines {
  std::string begin;  ///< the first line of its declaration
  std::size_t lines = 0;
  bool is_list = false;  ///< returns one static list: as long as the list
};

/// The functions of a source, and those that stand in its classes, by the indents of the house: from the first line of the declaration
/// to the closing brace at its indent.
std::vector<FunctionLines> functions_of(std::istream& source);

}  // namespace jointid::structure
