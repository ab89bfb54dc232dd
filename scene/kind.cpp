#include "scene/kind.hpp"

#include <fmt/format.h>

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

/// Appends a value so that no two values give one text.
struct ContentsWriter {
  std::string& out;

  void operator()(bool value) const { out += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { out += fmt::format("i{}", value); }
  void operator()(double value) const { out += fmt::format("d{}", value); }
  void operator()(const std::string& value) const { out += fmt::format("s{}:{}", value.size(), value); }
  void operator()(const DateOrTime&) const { out += "t"; }
  void operator()(const Array& values) const {
    out += '[';
    for (const Value& value : values) {
      std::visit(*this, value.content);
      out += ',';
    }
    out += ']';
  }
  void operator()(const Members& members) const {
    out += '{';
    for (const Member& each : members) {
      (*this)(each.key);
      std::visit(*this, each.value.content);
      out += ',';
    }
    out += '}';
  }
};

}  // namespace

std::string contents_of(const std::string& text, const std::filesystem::path& file) {
  Value document = parse_toml(text, file);
  if (auto* members = std::get_if<Members>(&document.content))
    std::erase_if(*members, [](const Member& each) { return each.key == "title"; });
  std::string out;
  std::visit(ContentsWriter{out}, document.content);
  return out;
}

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
