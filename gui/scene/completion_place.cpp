#include "gui/scene/completion_place.hpp"

#include <algorithm>
#include <sstream>

namespace jointid::gui {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The path of a header "[joint.stiffness]" or "[[joints]]", or empty: a line of an array of arrays is none.
std::string header(const std::string& line) {
  const std::string text = trimmed(line);
  if (!text.starts_with('[')) return "";
  const std::size_t open = text.starts_with("[[") ? 2 : 1;
  const std::size_t close = text.find(']', open);
  if (close == std::string::npos) return "";
  const std::string rest = trimmed(text.substr(close + open));
  const std::string path = trimmed(text.substr(open, close - open));
  const bool is_path = std::ranges::none_of(path, [](char c) { return c == ',' || c == ' ' || c == '+'; });
  return is_path && (rest.empty() || rest.starts_with('#')) ? path : "";
}

std::string key_of(const std::string& line) {
  const std::size_t equals = line.find('=');
  return equals == std::string::npos ? "" : trimmed(line.substr(0, equals));
}

bool is_word(char c) {
  return c == '_' || c == '-' || c == '.' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_in_string(const std::string& line) { return std::ranges::count(line, '"') % 2 != 0; }

/// How far brackets of values are open after a line, strings left out.
int depth_of(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (const char c : text) {
    if (c == '"') in_string = !in_string;
    if (!in_string && c == '#') break;
    if (!in_string && c == '[') ++depth;
    if (!in_string && c == ']') --depth;
  }
  return depth;
}

/// Follows tables and keys line by line.
struct Reader {
  std::string table, key;
  int depth = 0;

  void take(const std::string& line) {
    if (depth <= 0 && !header(line).empty()) {
      table = header(line);
      key.clear();
      return;
    }
    const std::size_t equals = line.find('=');
    if (depth <= 0 && !trimmed(line).starts_with('#') && equals != std::string::npos) key = key_of(line);
    depth = std::max(0, depth + depth_of(depth <= 0 && equals != std::string::npos ? line.substr(equals) : line));
  }
};

std::string last_word(const std::string& text, bool quoted) {
  std::size_t begin = quoted ? text.rfind('"') + 1 : text.size();
  while (!quoted && begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin);
}

}  // namespace

CompletionPlace completion_place(const std::string& before) {
  Reader reader;
  std::istringstream lines(before);
  std::string line, current;
  for (bool first = true; std::getline(lines, line); first = false) {
    if (!first) reader.take(current);
    current = line;
  }
  if (before.ends_with('\n')) {
    reader.take(current);
    current.clear();
  }
  using Kind = CompletionPlace::Kind;
  const std::string text = trimmed(current);
  const bool quoted = is_in_string(current);
  if (!quoted && current.find('#') != std::string::npos) return {};
  if (reader.depth > 0) return {quoted ? Kind::value : Kind::none, reader.table, reader.key, last_word(current, quoted)};
  if (current.find('=') != std::string::npos) {
    return {quoted ? Kind::value : Kind::none, reader.table, key_of(current), last_word(current, quoted)};
  }
  if (text.starts_with('[')) return {Kind::header, "", "", last_word(current, false)};
  return {Kind::key, reader.table, "", last_word(current, false)};
}

int line_of_key(const std::string& text, const std::string& table, const std::string& key) {
  Reader reader;
  std::istringstream lines(text);
  int number = 0, of_table = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool inside = reader.depth > 0;
    reader.take(line);
    if (inside || reader.table != table) continue;
    if (of_table == 0) of_table = number;
    if (!key.empty() && reader.key == key && key_of(line) == key) return number;
  }
  return of_table;
}

std::string tables_below(const std::string& text, const std::string& table) {
  Reader reader;
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    reader.take(line);
    if (reader.table == table || reader.table.starts_with(table + ".")) out += line + "\n";
  }
  return out;
}

}  // namespace jointid::gui
