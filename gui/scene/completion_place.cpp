#include "gui/scene/completion_place.hpp"

#include <algorithm>
#include <sstream>

#include "gui/scene/table_path.hpp"

namespace jointid::gui {
namespace {

std::string key_of(const std::string& line) {
  const std::size_t equals = line.find('=');
  return equals == std::string::npos ? "" : without_blanks(line.substr(0, equals));
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
  TablePath table;
  std::string key;
  int depth = 0;

  void take(const std::string& line) {
    if (depth <= 0 && table.take(line)) return key.clear();
    const std::size_t equals = line.find('=');
    if (depth <= 0 && !without_blanks(line).starts_with('#') && equals != std::string::npos) key = key_of(line);
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
  const std::string text = without_blanks(current);
  const bool quoted = is_in_string(current);
  if (!quoted && current.find('#') != std::string::npos) return {};
  if (reader.depth > 0) return {quoted ? Kind::value : Kind::none, reader.table.plain(), reader.key, last_word(current, quoted)};
  if (current.find('=') != std::string::npos) {
    return {quoted ? Kind::value : Kind::none, reader.table.plain(), key_of(current), last_word(current, quoted)};
  }
  if (text.starts_with('[')) return {Kind::header, "", "", last_word(current, false)};
  return {Kind::key, reader.table.plain(), "", last_word(current, false)};
}

int line_of_key(const std::string& text, const std::string& table, const std::string& key) {
  Reader reader;
  std::istringstream lines(text);
  int number = 0, of_table = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool inside = reader.depth > 0;
    reader.take(line);
    if (inside || !reader.table.is(table)) continue;
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
    if (reader.table.is_in(table)) out += line + "\n";
  }
  return out;
}

std::string table_at(const std::string& text, int line) {
  Reader reader;
  std::istringstream lines(text);
  std::string one;
  for (int number = 1; number <= line && std::getline(lines, one); ++number) reader.take(one);
  return reader.table.numbered();
}

std::vector<TextTable> tables_in(const std::string& text) {
  Reader reader;
  std::istringstream lines(text);
  std::vector<TextTable> tables(1);
  for (std::string line; std::getline(lines, line);) {
    const bool inside = reader.depth > 0;
    reader.take(line);
    if (inside) continue;
    if (reader.table.numbered() != tables.back().path) tables.push_back({reader.table.numbered(), {}});
    if (!reader.key.empty() && key_of(line) == reader.key) tables.back().keys.push_back(reader.key);
  }
  return tables;
}

int behind_tables(const std::string& text, const std::string& table) {
  Reader reader;
  std::istringstream lines(text);
  int number = 0, last = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool inside = reader.depth > 0;
    reader.take(line);
    const bool counts = inside || (!without_blanks(line).empty() && !without_blanks(line).starts_with('#'));
    if (reader.table.is_in(table) && counts) last = number;
  }
  return last == 0 ? 0 : last + 1;
}

}  // namespace jointid::gui
