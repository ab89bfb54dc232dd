#include "frf/uff/uff_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <system_error>

#include "frf/text/label_text.hpp"
#include "frf/text/special_number.hpp"

namespace jointid::frf::uff {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\0' || c == '\t' || c == '\r' || c == '\n' || c == '\x1A'; }

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Powers of ten that doubles hold.
constexpr std::array<double, 23> exact_powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool is_ascii(std::string_view line) {
  return std::ranges::all_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Reads a number whose exponent letter from_chars does not know, or which has none.
std::optional<double> parse_with_exponent(std::string_view text) {
  const std::size_t split = text.find_first_of("EeDd+-", 1);
  const std::string_view mantissa = text.substr(0, split);
  std::string_view exponent = split == std::string_view::npos ? "0" : text.substr(split);
  if (exponent.find_first_of("EeDd") == 0) exponent.remove_prefix(1);
  if (!exponent.empty() && exponent[0] == '+') exponent.remove_prefix(1);
  std::array<char, 64> buffer{};
  if (mantissa.size() + exponent.size() + 1 > buffer.size()) return std::nullopt;
  char* end = buffer.data() + mantissa.copy(buffer.data(), mantissa.size());
  *end++ = 'e';
  end += exponent.copy(end, exponent.size());
  double value = 0.0;
  const auto [last, error] = std::from_chars(buffer.data(), end, value);
  if (last != end) return std::nullopt;
  if (error == std::errc::result_out_of_range && exponent[0] == '-') return 0.0;
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string one_byte_per_column(std::string_view line) {
  if (is_ascii(line)) return std::string(line);
  std::string columns;
  columns.reserve(line.size());
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t length = utf8_length(line.substr(at));
    if (length == 0) return std::string(line);
    const auto first = static_cast<unsigned char>(line[at]);
    if (length == 1) {
      columns += line[at];
    } else if (length == 2 && first < 0xC4) {
      columns += static_cast<char>(((first & 0x03) << 6) | (static_cast<unsigned char>(line[at + 1]) & 0x3F));
    } else {
      columns += '?';
    }
    at += length;
  }
  return columns;
}

std::string to_utf8(std::string_view latin1) {
  std::string text;
  text.reserve(latin1.size());
  for (const char character : latin1) {
    const auto code = static_cast<unsigned char>(character);
    if (code < 0x80) {
      text += character;
    } else {
      text += static_cast<char>(0xC0 | (code >> 6));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

std::string_view column(std::string_view line, std::size_t begin, std::size_t width) {
  return begin >= line.size() ? std::string_view() : trim(line.substr(begin, width));
}

std::array<std::string_view, 3> three_fields(std::string_view line, std::size_t begin, std::size_t width) {
  if (const auto parts = words(line); begin == 0 && parts.size() == 3) return {parts[0], parts[1], parts[2]};
  return {column(line, begin, width), column(line, begin + width, width), column(line, begin + 2 * width, width)};
}

bool has_wide_characters(std::string_view line) {
  if (is_ascii(line)) return false;
  bool wide = false;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t length = utf8_length(line.substr(at));
    if (length == 0) return false;
    wide = wide || length > 1;
    at += length;
  }
  return wide;
}

std::string text_column(std::string_view line, std::size_t begin, std::size_t width) {
  if (!has_wide_characters(line)) return utf8_label(column(line, begin, width));
  const auto byte_of = [&](std::size_t wanted) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < wanted && at < line.size(); ++i) at += utf8_length(line.substr(at));
    return at;
  };
  const std::size_t from = byte_of(begin);
  return std::string(trim(line.substr(from, byte_of(begin + width) - from)));
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (auto begin = std::ranges::find_if_not(line, is_blank); begin != line.end();) {
    const auto end = std::find_if(begin, line.end(), is_blank);
    found.emplace_back(begin, end);
    begin = std::find_if_not(end, line.end(), is_blank);
  }
  return found;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = trim(text);
  if (text.empty()) return 0;
  if (text[0] == '+' && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || last != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> parse_real(std::string_view text) {
  text = trim(text);
  if (!text.empty() && text[0] == '+' && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  double value = 0.0;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && last == text.data() + text.size()) return value;
  return parse_with_exponent(text);
}

bool parse_short_real(const char* first, const char* last, double& value) {
  constexpr std::uint64_t most = std::uint64_t{1} << 53;
  constexpr std::ptrdiff_t most_digits = 18;  // no overflow of the mantissa
  const char* at = first;
  const bool negative = at != last && *at == '-';
  at += negative ? 1 : 0;
  std::uint64_t mantissa = 0;
  const auto digits = [&at, last, &mantissa] {
    const char* const begin = at;
    for (; at != last && is_digit(*at); ++at) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*at - '0');
    return at - begin;
  };
  if (last - at > most_digits + 5) return false;
  const std::ptrdiff_t whole = digits();
  if (whole == 0 || at == last || *at++ != '.') return false;
  const std::ptrdiff_t decimals = digits();
  if (whole + decimals > most_digits) return false;
  std::ptrdiff_t power = 0;
  if (at != last) {
    if (*at != 'E' && *at != 'e') return false;
    const bool below = ++at != last && *at == '-';
    at += below || (at != last && *at == '+') ? 1 : 0;
    if (at == last || last - at > 3) return false;
    for (; at != last && is_digit(*at); ++at) power = 10 * power + (*at - '0');
    if (at != last) return false;
    if (below) power = -power;
  }
  power -= decimals;
  if (mantissa > most || std::abs(power) >= std::ssize(exact_powers)) return false;
  const double number = negative ? -static_cast<double>(mantissa) : static_cast<double>(mantissa);
  const double scale = exact_powers[static_cast<std::size_t>(std::abs(power))];
  value = power < 0 ? number / scale : number * scale;
  return true;
}

std::optional<double> parse_value(std::string_view text) {
  const auto real = parse_real(text);
  return real ? real : special_number(text);
}

bool is_delimiter(std::string_view line) { return trim(line) == "-1" && line.find('1') < 6; }

}  // namespace jointid::frf::uff
