#include "frf/text/thousands.hpp"

#include <algorithm>
#include <array>

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 8> thousand_marks = {",", ".", "'", "\u2019", " ", "\u00a0", "\u2009", "\u202f"};

std::size_t count_digits(std::string_view text) { return std::min(text.find_first_not_of("0123456789"), text.size()); }

/// Takes one to three digits and groups of three behind `mark` off `rest`; the digits, empty where there is no group.
std::string take_groups(std::string_view& rest, std::string_view mark) {
  const std::size_t lead = count_digits(rest);
  if (lead == 0 || lead > 3) return {};
  std::string digits(rest.substr(0, lead));
  std::string_view left = rest.substr(lead);
  while (left.starts_with(mark) && count_digits(left.substr(mark.size())) == 3) {
    digits += left.substr(mark.size(), 3);
    left.remove_prefix(mark.size() + 3);
  }
  if (digits.size() == lead) return {};
  rest = left;
  return digits;
}

}  // namespace

std::optional<std::string> without_thousands(std::string_view cell) {
  const bool sign = cell.starts_with('-') || cell.starts_with('+');
  for (const std::string_view mark : thousand_marks) {
    std::string_view rest = cell.substr(sign ? 1 : 0);
    const std::string digits = take_groups(rest, mark);
    if (digits.empty()) continue;
    const bool decimals = !rest.empty() && (rest.front() == '.' || rest.front() == ',') && rest.substr(0, 1) != mark;
    if (!decimals && (mark == "," || mark == "." || mark == " " || !rest.empty())) return std::nullopt;
    const std::string_view fraction = decimals ? rest.substr(1) : std::string_view();
    if (count_digits(fraction) != fraction.size()) return std::nullopt;
    return std::string(cell.substr(0, sign ? 1 : 0)) + digits + "." + std::string(fraction);
  }
  return std::nullopt;
}

bool may_be_thousands(std::string_view cell) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  return !cell.starts_with('0') && !take_groups(cell, ",").empty() && cell.empty();
}

}  // namespace jointid::frf
