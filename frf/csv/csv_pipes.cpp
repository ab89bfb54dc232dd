#include "frf/csv/csv_pipes.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 6> upright_lines = {"│", "┃", "║", "┆", "┊", "╎"};

/// With "|" for the upright lines of boxes; empty where there is none.
std::string with_pipes(std::string_view line) {
  std::string text(line);
  for (const std::string_view box : upright_lines) {
    for (std::size_t at = text.find(box); at != std::string::npos; at = text.find(box, at)) text.replace(at, box.size(), "|");
  }
  return text.find('|') == std::string::npos ? std::string() : text;
}

/// "|---:|:---:|", "+====+====+", "├──┼──┤"
bool is_rule(std::string_view line) {
  const std::string_view text = trimmed(line);
  std::size_t strokes = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool box = text.substr(at, 2) == "\xE2\x94" || text.substr(at, 2) == "\xE2\x95";
    if (!box && std::string_view("|+-=: \t").find(text[at]) == std::string_view::npos) return false;
    if (box || text[at] == '-' || text[at] == '=') ++strokes;
    if (box) at += 2;
  }
  return strokes >= 3;
}

/// Between the pipes, without those at both ends of the line.
std::vector<std::string_view> piped_cells(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('|')) line.remove_prefix(1);
  if (line.ends_with('|')) line.remove_suffix(1);
  return split(line, '|');
}

bool is_row_of_pipes(const std::vector<std::string_view>& cells) {
  double value = 0.0;
  const auto number = [&](std::string_view cell) { return !cell.empty() && parse_cell(cell, true, value); };
  return cells.size() > 1 && (number(cells[0]) || (cells.size() > 2 && number(cells[1])));
}

void append_cells(std::string& out, const std::vector<std::string_view>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out += '\t';
    std::string cell(cells[i]);
    std::ranges::replace(cell, '\t', ' ');
    out += cell;
  }
}

}  // namespace

std::optional<std::string> tabs_for_pipes(std::string_view text) {
  if (text.find('|') == std::string_view::npos && text.find("\xE2\x94") == std::string_view::npos &&
      text.find("\xE2\x95") == std::string_view::npos)
    return std::nullopt;
  std::string out;
  bool rows = false;
  while (!text.empty()) {
    const std::string_view line = take_until(text, '\n');
    const std::string piped = with_pipes(line);
    if (!piped.empty() && !is_rule(line)) {
      const std::vector<std::string_view> cells = piped_cells(piped);
      rows = rows || is_row_of_pipes(cells);
      append_cells(out, cells);
    } else if (!is_rule(line)) {
      out.append(line);
    }
    out += '\n';
  }
  return rows ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace jointid::frf
