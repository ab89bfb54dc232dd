#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace jointid::scene {

using Path = std::filesystem::path;
using Matrix = std::vector<std::vector<double>>;
using Range = std::array<double, 2>;  ///< Hz, both ends included

struct Value;
struct Member;
using Array = std::vector<Value>;
using Members = std::vector<Member>;  ///< in the order of the file
struct DateOrTime {};                 ///< no key of a scene takes one

/// A value of a scene file and the line it stands at; keeps the TOML parser's types out of the readers.
struct Value {
  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Members> content;
  std::size_t line = 0;
};

/// A key of a table and its value.
struct Member {
  std::string key;
  Value value;
};

/// Parses TOML text. Throws InputError (usage) with line and column for text that is not TOML or not UTF-8.
Value parse_toml(const std::string& text, const Path& file);

}  // namespace jointid::scene
