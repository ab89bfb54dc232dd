#include "frf/text/number_text.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

/// Takes what stands before the first blank or tab off `rest`.
std::string_view take_word(std::string_view& rest) {
  const std::size_t at = std::min(rest.find_first_of(" \t"), rest.size());
  const std::string_view word = rest.substr(0, at);
  rest.remove_prefix(at);
  return word;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
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
  const char* first = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* last = text.c_str() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last && !std::isinf(value);
}

}  // namespace jointid::frf
