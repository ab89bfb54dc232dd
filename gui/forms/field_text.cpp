#include "gui/forms/field_text.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "base/text.hpp"

namespace jointid::gui {
namespace {

using Texts = std::vector<std::string>;

bool is_list(ValueKind kind) {
  return kind == ValueKind::words || kind == ValueKind::texts || kind == ValueKind::dofs || kind == ValueKind::files;
}

std::string trimmed(const std::string& text) {
  constexpr const char* blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

Texts split(const std::string& text, char separator) {
  Texts parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += (c == '"' || c == '\\' ? std::string("\\") : std::string()) + c;
  return out + "\"";
}

/// The string that begins at `at`, which is moved behind it; none for anything that has escapes other than \" and \\.
std::optional<std::string> read_string(const std::string& value, std::size_t& at) {
  const char quote = at < value.size() ? value[at] : ' ';
  if ((quote != '"' && quote != '\'') || value.compare(at, 3, std::string(3, quote)) == 0) return std::nullopt;
  std::string out;
  for (++at; at < value.size() && value[at] != quote; ++at) {
    if (quote == '"' && value[at] == '\\') {
      ++at;
      if (at >= value.size() || (value[at] != '"' && value[at] != '\\')) return std::nullopt;
    }
    out += value[at];
  }
  if (at >= value.size()) return std::nullopt;
  ++at;
  return out;
}

/// The elements of a flat list of strings without commas in them.
std::optional<Texts> read_list(const std::string& value) {
  if (!value.starts_with('[') || !value.ends_with(']')) return std::nullopt;
  Texts texts;
  for (std::size_t at = 1;;) {
    at = value.find_first_not_of(" \t\r\n,", at);
    if (at + 1 == value.size()) return texts;
    const auto text = read_string(value, at);
    if (!text || text->empty() || text->find(',') != std::string::npos) return std::nullopt;
    texts.push_back(*text);
  }
}

bool has_comment(const std::string& value) {
  char quote = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (quote == '"' && value[i] == '\\') {
      ++i;
    } else if (quote != 0) {
      if (value[i] == quote) quote = 0;
    } else if (value[i] == '#') {
      return true;
    } else if (value[i] == '"' || value[i] == '\'') {
      quote = value[i];
    }
  }
  return false;
}

std::string in_one_line(const std::string& value) {
  std::string out;
  for (const std::string& line : split(value, '\n')) out += (out.empty() || line.empty() ? "" : " ") + line;
  return out;
}

bool is_number(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && last == end;
}

}  // namespace

ShownValue shown_value(ValueKind kind, const std::string& value) {
  if (has_comment(value)) return {in_one_line(value), true};
  if (is_list(kind)) {
    const auto texts = read_list(value);
    return {texts ? comma_list(*texts) : in_one_line(value), false};
  }
  if (kind == ValueKind::text || kind == ValueKind::word) {
    std::size_t end = 0;
    const auto text = read_string(value, end);
    return {text && end == value.size() ? *text : value, false};
  }
  return {in_one_line(value), false};
}

ValueKind kind_as_written(const std::string& value) {
  std::size_t end = 0;
  if (read_string(value, end) && end == value.size()) return ValueKind::text;
  if (value == "true" || value == "false") return ValueKind::flag;
  const auto texts = read_list(value);
  return texts && !texts->empty() ? ValueKind::texts : ValueKind::value;
}

std::string written_value(ValueKind kind, const std::string& shown) {
  const std::string text = trimmed(shown);
  if (text.empty()) return "";
  if (is_list(kind)) {
    if (text.starts_with('[')) return text;
    Texts texts;
    for (const std::string& part : split(text, ',')) {
      if (!part.empty()) texts.push_back(quoted(part));
    }
    return "[" + comma_list(texts) + "]";
  }
  if (kind == ValueKind::text || kind == ValueKind::word)
    return text.starts_with('"') || text.starts_with('\'') ? text : quoted(text);
  if (kind == ValueKind::interval && !text.starts_with('[')) return "[" + text + "]";
  return text;
}

std::string pasted_cells(ValueKind kind, const std::string& cells) {
  Texts flat, rows;
  for (const std::string& line : split(cells, '\n')) {
    if (line.empty()) continue;
    Texts row;
    for (const std::string& cell : split(line, '\t')) {
      flat.push_back(cell);
      row.push_back(is_number(cell) ? cell : quoted(cell));
    }
    rows.push_back("[" + comma_list(row) + "]");
  }
  return is_list(kind) || kind == ValueKind::interval ? comma_list(flat) : "[" + comma_list(rows) + "]";
}

}  // namespace jointid::gui
