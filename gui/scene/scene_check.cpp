#include "gui/scene/scene_check.hpp"

#include <cstdlib>

#include "gui/scene/completion_place.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/readable_scene.hpp"

namespace jointid::gui {
namespace {

/// 12 of "line 12, [joint] dofs"; else 0.
int line_in(const std::string& place) {
  constexpr std::string_view word = "line ";
  return place.starts_with(word) ? std::atoi(place.c_str() + word.size()) : 0;
}

/// "joint", "dofs" of "[joint] dofs" or "[joint] dofs[2]".
std::pair<std::string, std::string> table_and_key(const std::string& place) {
  const std::size_t close = place.find(']');
  if (!place.starts_with('[') || close == std::string::npos) return {};
  const std::size_t key = place.find_first_not_of(' ', close + 1);
  if (key == std::string::npos) return {place.substr(1, close - 1), ""};
  return {place.substr(1, close - 1), place.substr(key, place.find_first_of("[ ,", key) - key)};
}

}  // namespace

CheckedScene check_scene(const std::string& text, const std::filesystem::path& file) {
  try {
    return {ident::parse_scene(text, file), {}};
  } catch (const InputError& error) {
    return {{}, located(error, text), ident::parse_readable(text, file)};
  }
}

SceneError located(const InputError& error, const std::string& text) {
  const InputError::Parts& parts = error.parts();
  int line = line_in(parts.place);
  if (const auto [table, key] = table_and_key(parts.place); line == 0 && !table.empty()) line = line_of_key(text, table, key);
  std::string problem = parts.problem;
  if (line == 0 && !parts.place.empty()) problem = parts.place + ": " + problem;
  return {line, std::move(problem), parts.remedy};
}

}  // namespace jointid::gui
