#include "frf/text/complex_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// In lower case, without blanks and the brackets around it.
std::string without_frame(std::string_view cell) {
  std::string text = lower_case(cell);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '"'; });
  const auto enclosed = [&](char open, char close) { return text.size() > 2 && text.front() == open && text.back() == close; };
  return enclosed('(', ')') || enclosed('[', ']') ? text.substr(1, text.size() - 2) : text;
}

/// A number, not an empty text.
bool reads_as(std::string_view text, double& value) { return !text.empty() && parse_cell(text, false, value); }

Complex both_or_neither(double re, double im) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return std::isnan(re) || std::isnan(im) ? Complex{none, none} : Complex{re, im};
}

/// "(1.2,3.4)"
std::optional<Complex> complex_of_pair(std::string_view text) {
  const std::size_t comma = text.find(',');
  double re = 0.0, im = 0.0;
  const bool pair = comma != std::string_view::npos && text.find('.') != std::string_view::npos;
  if (!pair || !reads_as(text.substr(0, comma), re) || !reads_as(text.substr(comma + 1), im)) return std::nullopt;
  return both_or_neither(re, im);
}

bool is_imaginary_unit(char c) { return c == 'i' || c == 'j'; }

/// "3.4*i" as "3.4i", "3.4im" as "3.4i", "-j3.4" and "-j*3.4" as "-3.4j".
std::string with_unit_behind(std::string text) {
  std::erase(text, '*');
  if (text.ends_with("im")) text.pop_back();
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool leads = is_imaginary_unit(text[at]) && (at == 0 || text[at - 1] == '+' || text[at - 1] == '-');
    if (!leads || text.substr(at, 3) == "inf") continue;
    const char unit = text[at];
    return text.erase(at, 1) + unit;
  }
  return text;
}

/// Where the imaginary part begins: its sign, which is none of an exponent.
std::size_t begin_of_imaginary(std::string_view text) {
  for (std::size_t at = text.size(); at-- > 0;) {
    const bool sign = text[at] == '+' || text[at] == '-';
    if (sign && (at == 0 || text[at - 1] != 'e')) return at;
  }
  return 0;
}

}  // namespace

std::optional<Complex> parse_complex(std::string_view cell, bool decimal_comma) {
  std::string text = without_frame(cell);
  if (const auto pair = complex_of_pair(text); pair && cell.find('(') != std::string_view::npos) return pair;
  if (decimal_comma) std::ranges::replace(text, ',', '.');
  text = with_unit_behind(std::move(text));
  if (text.size() < 2 || !is_imaginary_unit(text.back())) return std::nullopt;
  text.pop_back();
  const std::size_t at = begin_of_imaginary(text);
  double re = 0.0, im = 0.0;
  if ((at > 0 && !reads_as(text.substr(0, at), re)) || !reads_as(text.substr(at), im)) return std::nullopt;
  return both_or_neither(re, im);
}

}  // namespace jointid::frf
