#include "scene/kind.hpp"

#include <algorithm>

#include "scene/value.hpp"

namespace jointid::scene {
namespace {

const Value* member(const Value& table, const std::string& key) {
  const auto* members = std::get_if<Members>(&table.content);
  if (members == nullptr) return nullptr;
  const auto found = std::ranges::find(*members, key, &Member::key);
  return found == members->end() ? nullptr : &found->value;
}

}  // namespace

bool is_law_scene(const std::string& text, const std::filesystem::path& file) {
  const Value document = parse_toml(text, file);
  const Value *joint = member(document, "joint"), *data = member(document, "data");
  return (joint != nullptr && member(*joint, "friction") != nullptr) || (data != nullptr && member(*data, "levels") != nullptr);
}

bool is_line_scene(const std::string& text, const std::filesystem::path& file) {
  const Value document = parse_toml(text, file);
  const Value *joint = member(document, "joint"), *joints = member(document, "joints");
  if (joint != nullptr && member(*joint, "lines") != nullptr) return true;
  const Array* const list = joints == nullptr ? nullptr : std::get_if<Array>(&joints->content);
  return list != nullptr && std::ranges::any_of(*list, [](const Value& one) { return member(one, "lines") != nullptr; });
}

}  // namespace jointid::scene
