#include "gui/scene/scene_words.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::gui {
namespace {

using Words = std::vector<std::string>;
using Line = std::pair<std::string, std::string>;  // key, value

constexpr const char* no_word = "this-is-surely-no-word-of-any-scene";  // far from every word, so that the reader names them all

const Words least_files = {"a", "b", "c"};  // of the least scene

constexpr const char* any_file = "data.files.*";
constexpr const char* date = "1979-05-27";  // which no key takes
constexpr const char* gaussian = "'gaussian'";
constexpr const char* hammer = "'hammer'";  // which has other keys than the other laws of noise

/// The least that the reader wants to see of each table before it looks at anything else there.
const std::vector<std::pair<std::string, std::vector<Line>>>& least_scene() {
  static const std::vector<std::pair<std::string, std::vector<Line>>> scene = {
      {"", {}},
      {"data", {{"substructures", "['a', 'b']"}, {"assembly", "['c']"}}},
      {"joint", {{"dofs", "['1:+X', '2:+X']"}}},
      {"joint.stiffness", {{"pattern", "'full'"}}},
      {"noise", {{"model", gaussian}, {"level", "0.01"}}}};
  return scene;
}

/// The same of tables of which there may be several, which the least scene has not.
const std::map<std::string, std::vector<Line>>& least_of_several() {
  static const std::map<std::string, std::vector<Line>> tables = {
      {"data.gains", {{"gain", "0.01"}}},
      {"data.masses", {{"dofs", "['1:+X']"}, {"files", "['a']"}, {"mass", "0.003"}}},
      {"virtual_points",
       {{"name", "'VP1'"}, {"position", "[0, 0, 0]"}, {"plane", "'XY'"}, {"sensors", "['7:+X', '7:+Y', '8:+Y']"}}}};
  return tables;
}

/// What the reader says of the least scene with one more line, which replaces the others of its table where they are `alone`;
/// empty where it takes it. `model`: of the noise.
InputError::Parts answer(const std::string& table, const Line& more, const char* model, bool alone = false) {
  std::string text;
  bool done = false;
  const auto add = [&](const std::string& path, std::vector<Line> lines) {
    if (path == "noise" && model == hammer) lines = {{"model", hammer}};
    if (path == table) {
      std::erase_if(lines, [&](const Line& line) { return alone || line.first == more.first; });
      lines.push_back(more);
      done = true;
    }
    if (!path.empty()) text += least_of_several().contains(path) ? "[[" + path + "]]\n" : "[" + path + "]\n";
    for (const auto& [key, value] : lines) text += key + " = " + value + "\n";
  };
  for (const auto& [path, lines] : least_scene()) add(path, lines);
  const auto several = least_of_several().find(table);
  if (!done) add(table, several == least_of_several().end() ? std::vector<Line>() : several->second);
  try {
    ident::parse_scene(text, {});
  } catch (const InputError& error) {
    return error.parts();
  }
  return {};
}

/// The remedy for a wrong word, where the reader finds that this is the problem.
std::string remedy_of(const std::string& table, const Line& more, const std::string& problem, const char* model = gaussian) {
  const InputError::Parts found = answer(table, more, model);
  const bool meant = found.problem.find(problem) != std::string::npos && found.problem.find(no_word) != std::string::npos;
  return meant ? found.remedy : "";
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

/// The table that the least scene has in place of this one: [[joints]] has those of [joint], one file the keys of another.
std::string as_single(const std::string& table) {
  if (table.starts_with("data.files.")) return "data.files.a";
  if (!table.starts_with("joints")) return table;
  const std::size_t below = table.find('.');
  return "joint" + (below == std::string::npos ? "" : table.substr(below));
}

/// What the reader expects in place of `line`'s value: "a number", "[lo, hi]"; empty where it complains of anything else.
std::string wanted_for(const std::string& table, const Line& line) {
  const bool of_matrix = as_single(table).starts_with("joint.");  // all matrices have the same keys
  const std::string asked = of_matrix ? "joint.stiffness" : as_single(table);
  for (const bool alone : {false, true}) {
    for (const char* model : {gaussian, hammer}) {
      const std::string problem = answer(asked, line, model, alone).problem;
      const std::size_t end = problem.find(", found a date");
      if (problem.starts_with("expected ") && end != std::string::npos) return problem.substr(9, end - 9);
    }
  }
  return "";
}

bool is_table(const std::string& path, const std::string& key) {
  const std::string whole = path.empty() ? key : path + "." + key;
  return !keys_of(whole).empty();
}

Words find_tables(const std::string& path) {
  Words found;
  for (const std::string& key : keys_of(path)) {
    if (key == "joints" || !is_table(path, key)) continue;
    found.push_back(path.empty() ? key : path + "." + key);
    if (found.back() == "data.files") {  // its keys are the files of the least scene, which all have the same
      found.push_back(any_file);
      continue;
    }
    const Words below = find_tables(found.back());
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

/// What was asked before: the reader answers alike for as long as the program runs. For several threads.
template <class Value>
class Kept {
 public:
  template <class Ask>
  Value of(const std::string& question, const Ask& ask) {
    const std::scoped_lock lock(mutex_);
    const auto found = answers_.find(question);
    return found != answers_.end() ? found->second : answers_.emplace(question, ask()).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Value> answers_;
};

Words ask_for_keys(const std::string& table) {
  Words keys;
  for (const char* model : {gaussian, hammer}) {
    for (const std::string& key : listed(remedy_of(as_single(table), {no_word, "1"}, "is not known here", model))) {
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
    if (table != "noise") break;
  }
  if (table.starts_with("joints") && table.find('.') == std::string::npos) keys.insert(keys.begin(), "name");
  return keys;
}

/// Those of a list of files are the files of the least scene.
Words named_by_reader(const std::string& table, const std::string& key) {
  const std::string word = "'" + std::string(no_word) + "'";
  for (const std::string& value : {word, "[" + word + "]"}) {
    Words words = listed(remedy_of(as_single(table), {key, value}, "is not a valid word"));
    if (!words.empty()) return words;
  }
  return {};
}

Words ask_for_words(const std::string& table, const std::string& key) {
  const Words words = named_by_reader(table, key);
  return words == least_files ? Words() : words;
}

ValueKind ask_for_kind(const std::string& table, const std::string& key) {
  if (table.starts_with("joints") && key == "name") return ValueKind::text;  // which [joint] has not
  const std::string word = "'" + std::string(no_word) + "'";
  if (!words_of(table, key).empty()) {
    return listed(remedy_of(as_single(table), {key, word}, "is not a valid word")).empty() ? ValueKind::words : ValueKind::word;
  }
  if (named_by_reader(table, key) == least_files) return ValueKind::files;
  const std::string wanted = wanted_for(table, {key, date});
  if (wanted == "a number") return ValueKind::number;
  if (wanted == "true or false") return ValueKind::flag;
  if (wanted == "a string") return ValueKind::text;
  if (wanted == "[lo, hi]") return ValueKind::interval;
  if (wanted != "an array" || wanted_for(table, {key, "[" + std::string(date) + "]"}) != "a string") return ValueKind::value;
  const std::string problem = answer(as_single(table), {key, "[" + word + "]"}, gaussian).problem;
  return problem.find("DOF") == std::string::npos ? ValueKind::texts : ValueKind::dofs;
}

}  // namespace

Words keys_of(const std::string& table) {
  static Kept<Words> kept;
  return kept.of(table, [&] { return ask_for_keys(table); });
}

Words words_of(const std::string& table, const std::string& key) {
  static Kept<Words> kept;
  return kept.of(table + " " + key, [&] { return ask_for_words(table, key); });
}

ValueKind kind_of(const std::string& table, const std::string& key) {
  static Kept<ValueKind> kept;
  return kept.of(table + " " + key, [&] { return ask_for_kind(table, key); });
}

bool is_of_several(const std::string& table) { return table == "joints" || least_of_several().contains(table); }

void ask_for_everything() {
  for (const std::string& table : all_tables()) {
    for (const std::string& key : keys_of(table)) {
      kind_of(table, key);
      words_of(table, key);
    }
  }
}

Words all_tables() {
  static const Words tables = find_tables("");
  return tables;
}

}  // namespace jointid::gui
