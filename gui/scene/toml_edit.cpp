#include "gui/scene/toml_edit.hpp"

#include <algorithm>

#include "gui/scene/completion_place.hpp"
#include "gui/scene/table_path.hpp"

namespace jointid::gui {
namespace {

/// One past the value that begins at `at`: strings and brackets are followed, a comment behind it is not part of it.
std::size_t end_of_value(const std::string& text, std::size_t at) {
  int depth = 0;
  std::size_t end = at;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      for (++at; at < text.size() && text[at] != c && text[at] != '\n'; ++at) at += c == '"' && text[at] == '\\' ? 1U : 0U;
    } else if (c == '#') {
      if (depth == 0) break;
      at = std::min(text.find('\n', at), text.size());
      continue;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == '\n' && depth <= 0) {
      break;
    }
    if (at < text.size() && text[at] != ' ' && text[at] != '\t' && text[at] != '\r') end = at + 1;
  }
  return std::min(end, text.size());
}

/// Behind the last line of a table that is neither empty nor a comment.
std::size_t end_of_table(const std::string& text, const std::string& table) {
  const int header = line_of_key(text, table, "");
  std::size_t end = begin_of_line(text, header + 1);
  for (std::size_t at = end; at < text.size();) {
    const std::size_t first = text.find_first_not_of(" \t\r", at);
    if (first == std::string::npos || text[first] == '[') break;
    const std::size_t equals = text.find('=', first);
    const std::size_t newline = std::min(text.find('\n', at), text.size());
    const bool is_key = text[first] != '#' && equals < newline;
    const std::size_t behind =
        is_key ? std::min(text.find('\n', end_of_value(text, equals + 1)), text.size() - 1) + 1 : newline + 1;
    if (is_key) end = std::min(behind, text.size());
    at = behind;
  }
  return end;
}

/// Where `key = value` stands; `line` and `end` of it, `value` begins behind the equals sign.
struct Assignment {
  std::size_t line = 0, value = 0, end = 0;
};

std::optional<Assignment> find_here(const std::string& text, const std::string& table, const std::string& key) {
  const int number = line_of_key(text, table, key);
  if (number == 0) return std::nullopt;
  Assignment found;
  found.line = begin_of_line(text, number);
  const std::size_t first = text.find_first_not_of(" \t", found.line);
  if (first == std::string::npos || text.compare(first, key.size(), key) != 0) return std::nullopt;
  const std::size_t equals = text.find_first_not_of(" \t", first + key.size());
  if (equals == std::string::npos || text[equals] != '=') return std::nullopt;
  found.value = std::min(text.find_first_not_of(" \t", equals + 1), text.size());
  found.end = end_of_value(text, found.value);
  return found;
}

/// In its table, or with a dotted key in one above: `stiffness.pattern` of [joint].
std::optional<Assignment> find_assignment(const std::string& text, std::string table, std::string key) {
  for (;;) {
    if (const auto found = find_here(text, table, key)) return found;
    if (table.empty()) return std::nullopt;
    const auto [above, last] = parted(table);
    key = last + "." + key;
    table = above;
  }
}

/// Without the header of a table in which nothing is left; a comment behind the header stays.
std::string without_empty_table(const std::string& text, const std::string& table) {
  const int header = line_of_key(text, table, "");
  const std::size_t begin = begin_of_line(text, header), behind = begin_of_line(text, header + 1);
  if (header == 0 || table.empty() || numbered_part(table) == table || text.find('[', begin) >= behind) return text;
  const std::size_t next = text.find_first_not_of(" \t\r\n", behind);
  if (next != std::string::npos && text[next] != '[') return text;
  const std::size_t comment = text.find('#', begin);
  const std::string kept = comment < behind ? text.substr(comment, behind - comment) : "";
  const std::size_t from = kept.empty() && begin > 1 && text[begin - 2] == '\n' ? begin - 1 : begin;
  return text.substr(0, from) + kept + text.substr(behind);
}

int line_at(const std::string& text, std::size_t place) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

}  // namespace

std::size_t begin_of_line(const std::string& text, int number) {
  std::size_t at = 0;
  for (int line = 1; line < number && at < text.size(); ++line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

std::vector<std::string> strings_in(const std::string& value) {
  std::vector<std::string> found;
  for (std::size_t at = 0; at < value.size(); ++at) {
    if (value[at] == '#') at = std::min(value.find('\n', at), value.size());
    if (at >= value.size() || (value[at] != '"' && value[at] != '\'')) continue;
    const std::size_t end = std::min(value.find(value[at], at + 1), value.size());
    found.push_back(value.substr(at + 1, end - at - 1));
    at = end;
  }
  return found;
}

std::optional<std::string> value_of(const std::string& text, const std::string& table, const std::string& key) {
  const auto found = find_assignment(text, table, key);
  if (!found) return std::nullopt;
  return text.substr(found->value, found->end - found->value);
}

std::optional<std::array<int, 2>> lines_of(const std::string& text, const std::string& table, const std::string& key) {
  const auto found = find_assignment(text, table, key);
  if (!found) return std::nullopt;
  return {{line_at(text, found->line), line_at(text, found->end)}};
}

std::string with_value(const std::string& text, const std::string& table, const std::string& key, const std::string& value) {
  std::string out = text;
  if (const auto found = find_assignment(text, table, key)) return out.replace(found->value, found->end - found->value, value);
  const std::string line = key + " = " + value + "\n";
  if (table.empty()) return line + out;
  if (!out.empty() && out.back() != '\n') out += '\n';
  if (line_of_key(text, table, "") == 0) {
    const std::string array = numbered_part(table);
    const std::size_t behind = array.empty() ? out.size() : begin_of_line(out, behind_tables(out, array));
    return out.insert(behind, "\n" + header_of(table) + "\n" + line);
  }
  return out.insert(end_of_table(out, table), line);
}

std::string without_value(const std::string& text, const std::string& table, const std::string& key) {
  const auto found = find_assignment(text, table, key);
  if (!found) return text;
  const std::size_t rest = std::min(text.find_first_not_of(" \t\r", found->end), text.size());
  if (rest < text.size() && text[rest] == '#') return text.substr(0, found->line) + text.substr(rest);
  return without_empty_table(text.substr(0, found->line) + text.substr(std::min(rest + 1, text.size())), table);
}

}  // namespace jointid::gui
