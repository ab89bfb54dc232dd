#include "scene/value.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/error.hpp"
#include "scene/text.hpp"

namespace jointid::scene {
namespace {

Value convert(const toml::node& node);

Members convert_table(const toml::table& table) {
  Members members;
  for (const auto& [key, node] : table) {
    members.push_back({std::string(key.str()), convert(node)});
    members.back().value.line = key.source().begin.line;
  }
  std::stable_sort(members.begin(), members.end(),
                   [](const Member& a, const Member& b) { return a.value.line < b.value.line; });
  return members;
}

Array convert_array(const toml::array& array) {
  Array values;
  for (const toml::node& node : array) values.push_back(convert(node));
  return values;
}

Value convert(const toml::node& node) {
  Value value;
  value.line = node.source().begin.line;
  if (const auto* table = node.as_table()) value.content = convert_table(*table);
  else if (const auto* array = node.as_array()) value.content = convert_array(*array);
  else if (const auto* text = node.as_string()) value.content = text->get();
  else if (const auto* integer = node.as_integer()) value.content = integer->get();
  else if (const auto* number = node.as_floating_point()) value.content = number->get();
  else if (const auto* boolean = node.as_boolean()) value.content = boolean->get();
  else value.content = DateOrTime{};
  return value;
}

std::string remedy_of(const std::string& text, const std::string& problem) {
  if (text.find('\0') != std::string::npos) return "is it a scene file (TOML)?";
  if (problem.find("cannot redefine") == std::string::npos) return "correct the TOML there";
  return "a key is in a table once; several springs of one name are a list: k1 = [[\"4:+Y\", \"5:+Y\"], [\"6:+Y\", "
         "\"7:+Y\"]]";
}

}  // namespace

Value parse_toml(const std::string& text, const Path& file) {
  check_key_depth(text, file);
  try {
    return convert(toml::parse(std::string_view(text)));
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    throw InputError({.kind = ErrorKind::usage,
                      .file = file.string(),
                      .place = "line " + std::to_string(at.line) + ", column " + std::to_string(at.column),
                      .problem = std::string(error.description()),
                      .remedy = remedy_of(text, std::string(error.description()))});
  }
}

}  // namespace jointid::scene
