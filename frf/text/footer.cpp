#include "frf/text/footer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "frf/text/number_text.hpp"
#include "frf/text/special_number.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view decimal_digits = "0123456789";

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && decimal_digits.find(text[at]) != std::string_view::npos;
}

bool begins_like_number(std::string_view cell) {
  const std::size_t at = cell.starts_with('+') || cell.starts_with('-') ? 1 : 0;
  return is_digit_at(cell, at) || (cell.substr(at).starts_with('.') && is_digit_at(cell, at + 1)) || cell.starts_with("\u2212");
}

/// "-----", "* * *", "====".
bool is_stroke(std::string_view cell) { return cell.size() > 2 && cell.find_first_not_of("-=*_~ ") == std::string_view::npos; }

}  // namespace

bool is_footer(const std::vector<std::string_view>& cells, std::size_t columns) {
  const auto filled = static_cast<std::size_t>(std::ranges::count_if(cells, [](auto cell) { return !cell.empty(); }));
  if (filled == 0 || cells.front().empty()) return false;
  const std::string_view first = cells.front();
  if (filled == 1 && is_stroke(first)) return true;
  double value = 0.0;
  if (begins_like_number(first) || parse_cell(first, true, value) || states_no_value(first)) return false;
  const bool words =
      std::none_of(cells.begin() + 1, cells.end(), [&](auto cell) { return !cell.empty() && parse_cell(cell, true, value); });
  return words || filled < columns;
}

bool is_page_mark(std::string_view text) {
  std::string plain = lower_case(text);
  std::erase_if(plain, [](char c) { return std::string_view(" \t\r;,.-/|\"").find(c) != std::string_view::npos; });
  std::string_view rest = plain;
  bool named = false;
  for (const std::string_view word : {"page", "seite", "página", "pagina", "pag"}) {
    if (named || !rest.starts_with(word)) continue;
    rest.remove_prefix(word.size());
    named = true;
  }
  const std::string_view strokes = trimmed(text);
  named = named || (strokes.size() > 4 && strokes.starts_with("- ") && strokes.ends_with(" -"));
  const std::size_t digits = std::min(rest.find_first_not_of(decimal_digits), rest.size());
  if (!named || digits == 0) return false;
  rest.remove_prefix(digits);
  for (const std::string_view word : {"of", "von", "de", "di", "sur"}) {
    if (rest.starts_with(word)) {
      rest.remove_prefix(word.size());
      break;
    }
  }
  return rest.find_first_not_of(decimal_digits) == std::string_view::npos;
}

bool warns_of_data(std::string_view text) {
  constexpr std::array<std::string_view, 8> words = {"overload", "over-range", "overrange", "clipp",
                                                     "abort",    "incomplete", "truncat",   "error"};
  const std::string plain = lower_case(text);
  return std::ranges::any_of(words, [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

bool ends_in_a_cut_number(std::string_view text) {
  constexpr std::size_t lines = 20, fewest = 4, least_length = 4;
  if (text.empty() || text.back() == '\n') return false;
  std::size_t last = 0, common = 0, count = 0;
  for (; count <= lines && !text.empty(); ++count) {
    const std::size_t begin = text.rfind('\n') == std::string_view::npos ? 0 : text.rfind('\n') + 1;
    const std::string_view line = trimmed(text.substr(begin));
    text = text.substr(0, begin == 0 ? 0 : begin - 1);
    const std::size_t sign = line.find_last_of(".,;|\t ");
    const bool decimals = sign != std::string_view::npos && (line[sign] == '.' || line[sign] == ',');
    const std::size_t length = decimals ? line.size() - sign : 0;
    if (count == 0) last = length;
    if (count == 1) common = length;
    if (count > 0 && (!decimals || length != common || std::isdigit(static_cast<unsigned char>(line.back())) == 0)) break;
  }
  return count > fewest && common > least_length && last < common;
}

}  // namespace jointid::frf
