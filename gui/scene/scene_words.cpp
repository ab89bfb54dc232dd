#include "gui/scene/scene_words.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::gui {
namespace {

using Words = std::vector<std::string>;
using Line = std::pair<std::string, std::string>;  // key, value

constexpr const char* no_word = "this-is-surely-no-word-of-any-scene";  // far from every word, so that the reader names them all

/// The least that the reader wants to see of each table before it looks at anything else there.
const std::vector<std::pair<std::string, std::vector<Line>>>& least_scene() {
  static const std::vector<std::pair<std::string, std::vector<Line>>> scene = {
      {"", {}},
      {"data", {{"substructures", "['a', 'b']"}, {"assembly", "['c']"}}},
      {"joint", {{"dofs", "['1:+X', '2:+X']"}}},
      {"joint.stiffness", {{"pattern", "'full'"}}},
      {"noise", {{"model", "'gaussian'"}, {"level", "0.01"}}}};
  return scene;
}

/// What the reader says of the least scene with one more line.
std::string remedy_of(const std::string& table, const Line& more, const std::string& problem) {
  std::string text;
  bool done = false;
  const auto add = [&](const std::string& path, std::vector<Line> lines) {
    if (path == table) {
      std::erase_if(lines, [&](const Line& line) { return line.first == more.first; });
      lines.push_back(more);
      done = true;
    }
    if (!path.empty()) text += "[" + path + "]\n";
    for (const auto& [key, value] : lines) text += key + " = " + value + "\n";
  };
  for (const auto& [path, lines] : least_scene()) add(path, lines);
  if (!done) add(table, {});
  try {
    ident::parse_scene(text, {});
  } catch (const InputError& error) {
    const std::string& found = error.parts().problem;
    if (found.find(problem) != std::string::npos && found.find(no_word) != std::string::npos) return error.parts().remedy;
  }
  return "";
}

/// The words of "use a, b or c".
Words listed(const std::string& remedy) {
  Words words;
  if (!remedy.starts_with("use ")) return words;
  std::string rest = remedy.substr(4);
  if (const std::size_t last = rest.rfind(" or "); last != std::string::npos) rest.replace(last, 4, ", ");
  for (std::size_t at = 0; at < rest.size();) {
    const std::size_t comma = std::min(rest.find(", ", at), rest.size());
    words.push_back(rest.substr(at, comma - at));
    at = comma + 2;
  }
  return words;
}

/// [[joints]] has the tables of [joint].
std::string as_single(const std::string& table) { return table.starts_with("joints") ? "joint" + table.substr(6) : table; }

bool is_table(const std::string& path, const std::string& key) {
  const std::string whole = path.empty() ? key : path + "." + key;
  return !keys_of(whole).empty();
}

Words find_tables(const std::string& path) {
  Words found;
  for (const std::string& key : keys_of(path)) {
    if (key == "joints" || !is_table(path, key)) continue;
    found.push_back(path.empty() ? key : path + "." + key);
    const Words below = find_tables(found.back());
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

}  // namespace

Words keys_of(const std::string& table) {
  Words keys = listed(remedy_of(as_single(table), {no_word, "1"}, "is not known here"));
  if (table == "joints") keys.insert(keys.begin(), "name");
  return keys;
}

Words words_of(const std::string& table, const std::string& key) {
  const std::string word = "'" + std::string(no_word) + "'";
  for (const std::string& value : {word, "[" + word + "]"}) {
    Words words = listed(remedy_of(as_single(table), {key, value}, "is not a valid word"));
    if (!words.empty()) return words;
  }
  return {};
}

Words all_tables() {
  static const Words tables = find_tables("");
  return tables;
}

}  // namespace jointid::gui
