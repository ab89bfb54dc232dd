#include "function_lines.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace jointid::structure {
namespace {

using Lines = std::vector<std::string>;

constexpr std::array<std::string_view, 2> indents = {"", "  "};  // of functions, and of those in classes

/// Whether a line begins a declaration that may be that of a function.
bool may_begin(std::string_view line, std::string_view indent) {
  if (!line.starts_with(indent) || line.size() <= indent.size()) return false;
  const std::string_view rest = line.substr(indent.size());
  if (std::string_view(" }/#{").find(rest.front()) != std::string_view::npos) return false;
  constexpr std::array<std::string_view, 8> others = {"namespace", "struct", "class", "enum", "union", "extern", "template", "using"};
  const std::string_view word = rest.substr(0, rest.find(' '));
  return std::ranges::find(others, word) == others.end();
}

/// The line on which the declaration that begins here opens a body; nothing where it opens none on a line of its own.
std::optional<std::size_t> body_of(const Lines& lines, std::size_t begin) {
  std::string declaration;
  for (std::size_t i = begin; i < lines.size() && !lines[i].empty(); ++i) {
    declaration += lines[i];
    const char last = lines[i].back();
    if (last != '{' && last != ';' && last != '}') continue;
    const std::size_t bracket = declaration.find('(');
    const bool is_function = bracket != std::string::npos && declaration.find(" = ") > bracket;
    return last == '{' && is_function ? std::optional(i) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<FunctionLines> functions_of(std::istream& source) {
  Lines lines;
  for (std::string line; std::getline(source, line);) lines.push_back(line);
  std::vector<FunctionLines> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::string_view indent : indents) {
      const auto body = may_begin(lines[i], indent) ? body_of(lines, i) : std::nullopt;
      if (!body) continue;
      std::size_t end = *body + 1;
      while (end < lines.size() && !lines[end].starts_with(std::string(indent) + "}")) ++end;
      const bool is_list = *body + 1 < lines.size() && lines[*body + 1].starts_with(std::string(indent) + "  static const");
      out.push_back({lines[i], end - i + 1, is_list});
      i = end;
      break;
    }
  }
  return out;
}

}  // namespace jointid::structure
