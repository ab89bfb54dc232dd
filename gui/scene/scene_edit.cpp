#include "gui/scene/scene_edit.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "gui/scene/completion_place.hpp"

namespace jointid::gui {
namespace {

/// Where line `number` (from 1) begins; the end of the text where there is none.
std::size_t begin_of_line(const std::string& text, int number) {
  std::size_t at = 0;
  for (int line = 1; line < number && at < text.size(); ++line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

/// One past the value that begins at `at`: strings and brackets are followed, a comment behind it is not part of it.
std::size_t end_of_value(const std::string& text, std::size_t at) {
  int depth = 0;
  std::size_t end = at;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      for (++at; at < text.size() && text[at] != c && text[at] != '\n'; ++at) at += c == '"' && text[at] == '\\' ? 1 : 0;
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

}  // namespace

std::string with_value(const std::string& text, const std::string& table, const std::string& key, const std::string& value) {
  std::string out = text;
  const int line = line_of_key(text, table, key);
  const int header = line_of_key(text, table, "");
  if (line > 0 && (line != header || table.empty())) {
    const std::size_t begin = text.find_first_not_of(" \t", text.find('=', begin_of_line(text, line)) + 1);
    return out.replace(begin, end_of_value(text, begin) - begin, value);
  }
  if (!out.empty() && out.back() != '\n') out += '\n';
  if (header == 0) return out + "\n[" + table + "]\n" + key + " = " + value + "\n";
  return out.insert(end_of_table(out, table), key + " = " + value + "\n");
}

std::string written(const std::vector<ident::Range>& ranges) {
  std::string text = "[";
  for (const auto& [low, high] : ranges) {
    text += (text.size() > 1 ? ", [" : "[") + digits(low, "%.10g") + ", " + digits(high, "%.10g") + "]";
  }
  return text + "]";
}

std::string written(const std::vector<frf::Dof>& dofs) {
  std::string text = "[";
  for (const frf::Dof& dof : dofs) text += (text.size() > 1 ? ", \"" : "\"") + dof.name() + "\"";
  return text + "]";
}

std::string with_way(std::string text, const study::Way& way) {
  const auto word = [](const std::string& value) { return '"' + value + '"'; };
  const auto set = [&text](const char* key, const std::string& value) { text = with_value(text, "identify", key, value); };
  std::string equations;
  for (const ident::Equation equation : way.equations) equations += (equations.empty() ? "" : ", ") + word(ident::name(equation));
  set("method", word(ident::name(way.method)));
  if (!equations.empty()) set("equations", "[" + equations + "]");
  set("solver", word(way.solver));
  if (!ident::weighs_equations(way.method)) return text;
  set("weighting", word(weighting::name(way.weighting)));
  set("delta", digits(way.delta, "%.10g"));
  return text;
}

std::vector<ident::Range> with_range(std::vector<ident::Range> ranges, const ident::Range& more) {
  ranges.push_back(more);
  std::ranges::sort(ranges);
  std::vector<ident::Range> out;
  for (const ident::Range& range : ranges) {
    if (!out.empty() && range[0] <= out.back()[1])
      out.back()[1] = std::max(out.back()[1], range[1]);
    else
      out.push_back(range);
  }
  return out;
}

}  // namespace jointid::gui
