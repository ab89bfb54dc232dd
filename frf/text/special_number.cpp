#include "frf/text/special_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

/// Digits that fill the field up and an exponent: "0000e+000". Two values that touch are not one.
bool is_filling(std::string_view text) {
  const auto skip_digits = [&] { text.remove_prefix(std::min(text.size(), text.find_first_not_of("0123456789"))); };
  skip_digits();
  if (text.starts_with('e') || text.starts_with('d')) {
    text.remove_prefix(1);
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    skip_digits();
  }
  return text.empty();
}

/// What follows the point of "1.#QNAN" as the C library of Windows wrote it; cut to fewer digits the last letter is rounded:
/// "1.#J", "1.$".
std::optional<double> of_old_windows(std::string_view text) {
  for (const std::string_view word : {"#qnan", "#snan", "#nan", "#ind", "#inf", "#q", "#r", "#s", "#j", "$"}) {
    if (text.starts_with(word) && is_filling(text.substr(word.size()))) return word == "#inf" || word == "#j" ? infinity : nan;
  }
  return std::nullopt;
}

/// "#DIV/0!", "#NAME?", "#N/A" in any language, "#####" where a column was too narrow, "Err:502" of LibreOffice.
bool is_spreadsheet_error(std::string_view word) {
  if (word.starts_with("err:")) return word.size() > 4 && word.find_first_not_of("0123456789", 4) == std::string_view::npos;
  if (!word.starts_with('#') || word.size() < 3) return false;
  constexpr std::array<std::string_view, 4> without_mark = {"#n/a", "#na", "#nv", "#n/d"};
  return word.ends_with('!') || word.ends_with('?') || std::ranges::find(without_mark, word) != without_mark.end() ||
         word.find_first_not_of('#') == std::string_view::npos;
}

}  // namespace

bool states_no_value(std::string_view cell) {
  constexpr std::array<std::string_view, 10> words = {"n/a",     "na",   "<na>",   "null",   "none",
                                                      "missing", "n.a.", "\u2013", "\u2014", "nil"};
  const std::string word = lower_case(cell);
  if (word.empty() || is_spreadsheet_error(word) || word.find_first_not_of('-') == std::string::npos) return true;
  const auto special = special_number(word);
  return (special && std::isnan(*special)) || std::ranges::find(words, word) != words.end();
}

std::optional<double> special_number(std::string_view text) {
  const std::string lower = lower_case(text);
  constexpr std::string_view blanks = " \t\r";
  std::string_view word = lower;
  word.remove_prefix(std::min(word.size(), word.find_first_not_of(blanks)));
  word = word.substr(0, word.find_last_not_of(blanks) + 1);
  if (word.empty()) return std::nullopt;
  if (std::ranges::all_of(word, [](char c) { return c == '*'; })) return nan;
  const double sign = word.starts_with('-') ? -1.0 : 1.0;
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  if (word == "inf" || word == "infinity") return sign * infinity;
  if (word == "nan" || word == "nanq" || word == "nans" || (word.starts_with("nan(") && word.find(')') + 1 == word.size()))
    return nan;
  if (!word.starts_with("1.") && !word.starts_with("1,")) return std::nullopt;
  const auto special = of_old_windows(word.substr(2));
  return special ? std::optional(sign * *special) : std::nullopt;
}

}  // namespace jointid::frf
