#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "input_folder.hpp"

namespace jointid::cli {

/// A way to be wrong: what is spoilt, the command, its exit code (2 or 3) and what its one line of error says.
struct Wrong {
  std::string name;
  Spoil spoil;
  std::vector<std::string> command;
  int code;
  std::vector<std::string> says;  ///< file, place, value and remedy, in this order
};

inline void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

/// Runs a Wrong: one line on stderr, nothing on stdout, no file made or changed. Its test is in wrong_input.cpp; tables
/// of ways are instantiated next to each other by topic.
class WrongInput : public ::testing::TestWithParam<Wrong> {};

inline std::string name_of(const ::testing::TestParamInfo<Wrong>& row) { return row.param.name; }

/// Solving the scene A1.toml, with an output file that exists and one that does not.
inline std::vector<std::string> solve() { return {"solve", "A1.toml", "--json", "old.json", "--csv", "new.csv"}; }

/// Reading a file whole.
inline std::vector<std::string> convert(const std::string& file) { return {"convert", file, "new.csv"}; }

}  // namespace jointid::cli
