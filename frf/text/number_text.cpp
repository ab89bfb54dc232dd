#include "frf/text/number_text.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "base/stop_scope.hpp"

namespace jointid::frf {
namespace {

/// Takes what stands before the first blank or tab off `rest`.
std::string_view take_word(std::string_view& rest) {
  const std::size_t at = std::min(rest.find_first_of(" \t"), rest.size());
  const std::string_view word = rest.substr(0, at);
  rest.remove_prefix(at);
  return word;
}

bool is_digit_of_number(char c) { return c >= '0' && c <= '9'; }

/// Without "\u00a0", "\u2009", "\u202f" at its ends.
void remove_fixed_blanks(std::string& text) {
  for (const std::string_view blank : {"\u00a0", "\u2009", "\u202f", " "}) {
    while (text.starts_with(blank)) text.erase(0, blank.size());
    while (text.ends_with(blank)) text.erase(text.size() - blank.size());
  }
}

/// A number of another notation as std::from_chars() reads it; false where there is nothing to change.
bool to_plain_number(std::string& text) {
  const std::string before = text;
  remove_fixed_blanks(text);
  constexpr std::string_view minus = "\u2212";
  for (std::size_t at = text.find(minus); at != std::string::npos; at = text.find(minus)) text.replace(at, minus.size(), "-");
  const std::size_t mark = text.find_first_of("dD");
  if (mark != std::string::npos && mark > 0 && (is_digit_of_number(text[mark - 1]) || text[mark - 1] == '.')) text[mark] = 'e';
  const std::size_t sign = text.find_last_of("+-");
  const bool bare = sign != std::string::npos && sign > 1 && sign + 4 == text.size() && is_digit_of_number(text[sign - 1]) &&
                    text.find('.') < sign && text.find_first_of("eE") == std::string::npos;
  if (bare) text.insert(sign, 1, 'e');
  return text != before;
}

bool parse_plain(const std::string& text, double& value) {
  const char* first = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* last = text.c_str() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last && !std::isinf(value);
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  constexpr std::size_t smallest = 1U << 14U, largest = 1U << 22U;
  std::string text;
  while (in) {
    stop_point();
    const std::size_t before = text.size(), piece = std::clamp(before, smallest, largest);
    text.resize(before + piece);
    in.read(text.data() + before, static_cast<std::streamsize>(piece));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || !in.is_open()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = path.string(),
                      .place = {},
                      .problem = std::string("cannot be read: ") + std::strerror(errno),
                      .remedy = {}});
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_until(std::string_view& rest, char end) {
  const std::size_t at = std::min(rest.find(end), rest.size());
  const std::string_view part = rest.substr(0, at);
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return part;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  if (separator == ' ') {
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) parts.push_back(take_word(line));
    return parts;
  }
  const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), separator)) + 1;
  for (std::size_t i = 0; i < count; ++i) parts.push_back(trimmed(take_until(line, separator)));
  return parts;
}

bool parse_cell(std::string_view cell, bool decimal_comma, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return true;
  std::string text(cell);
  if (decimal_comma) std::ranges::replace(text, ',', '.');
  if (parse_plain(text, value)) return true;
  return to_plain_number(text) && (text.empty() || parse_plain(text, value));
}

}  // namespace jointid::frf
