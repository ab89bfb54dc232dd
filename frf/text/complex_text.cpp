#include "frf/text/complex_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// "complex(1,2)", "np.complex128(1+2j)" as "(1,2)", "1+2j"; "1.2*^-3" of Mathematica as "1.2e-3".
std::string without_call(std::string text) {
  for (std::size_t at = text.find("*^"); at != std::string::npos; at = text.find("*^", at)) text.replace(at, 2, "e");
  for (const std::string_view name : {"np.complex128", "np.complex64", "complex128", "complex", "cmplx"}) {
    if (text.starts_with(name) && text.size() > name.size() + 2 && text[name.size()] == '(' && text.back() == ')')
      return text.substr(name.size() + 1, text.size() - name.size() - 2);
  }
  return text;
}

/// In lower case, without blanks and the brackets around it.
std::string without_frame(std::string_view cell) {
  std::string text = lower_case(cell);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '"'; });
  const auto enclosed = [&](char open, char close) { return text.size() > 2 && text.front() == open && text.back() == close; };
  return without_call(enclosed('(', ')') || enclosed('[', ']') ? text.substr(1, text.size() - 2) : text);
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

/// Takes the unit behind an angle off `text`.
AngleUnit take_angle_unit(std::string_view& text) {
  for (const std::string_view word : {"°", "º", "\xB0", "\xBA", "degrees", "degree", "deg"}) {
    if (!text.ends_with(word)) continue;
    text.remove_suffix(word.size());
    return AngleUnit::degrees;
  }
  for (const std::string_view word : {"radians", "radian", "rad"}) {
    if (!text.ends_with(word)) continue;
    text.remove_suffix(word.size());
    return AngleUnit::radians;
  }
  return AngleUnit::unstated;
}

/// "-j0.785", "-0.785j", "i*0.785", "45°j" without the imaginary unit; empty where it has none.
std::string without_imaginary_unit(std::string_view exponent) {
  std::string text(exponent);
  std::erase(text, '*');
  const std::size_t at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (text.size() > at + 1 && is_imaginary_unit(text[at])) return text.erase(at, 1);
  if (text.size() > at + 1 && is_imaginary_unit(text.back())) return text.substr(0, text.size() - 1);
  return {};
}

/// What stands before and behind the sign of an angle; behind an exponential function what it is of, without i.
std::optional<std::pair<std::string, std::string>> parts_of_polar(std::string text, bool& exponential) {
  for (const std::string_view sign : {"exp(", "e^(", "e**("}) {
    const std::size_t at = text.find(sign);
    if (at == std::string::npos || !text.ends_with(')')) continue;
    exponential = true;
    std::string before = text.substr(0, at);
    while (before.ends_with('*')) before.pop_back();
    if (before.ends_with("\u00b7")) before.erase(before.size() - 2);
    return std::pair{before.empty() && at == 0 ? "1" : before,
                     without_imaginary_unit(std::string_view(text).substr(at + sign.size(), text.size() - at - sign.size() - 1))};
  }
  for (const std::string_view sign : {"∠", "@", "/_", "cis", "angle", "arg", "at", "<"}) {
    const std::size_t at = text.find(sign);
    if (at == std::string::npos || at == 0) continue;
    std::string angle = text.substr(at + sign.size());
    if (angle.starts_with('(') && angle.ends_with(')')) angle = angle.substr(1, angle.size() - 2);
    std::string before = text.substr(0, at);
    if (sign == "cis" && before.ends_with('*')) before.pop_back();
    return std::pair{before, angle};
  }
  return std::nullopt;
}

}  // namespace

Complex PolarNumber::value() const {
  const double radians = unit == AngleUnit::radians || (unit == AngleUnit::unstated && cis) ? angle : angle * std::numbers::pi / 180.0;
  return both_or_neither(magnitude * std::cos(radians), magnitude * std::sin(radians));
}

std::optional<PolarNumber> parse_polar(std::string_view cell, bool decimal_comma) {
  std::string text = without_frame(cell);
  if (decimal_comma) std::ranges::replace(text, ',', '.');
  bool exponential = false;
  PolarNumber polar;
  polar.cis = text.find("cis") != std::string::npos;
  const auto parts = parts_of_polar(std::move(text), exponential);
  if (!parts) return std::nullopt;
  std::string_view angle = parts->second;
  polar.unit = take_angle_unit(angle);
  if (exponential && polar.unit == AngleUnit::unstated) polar.unit = AngleUnit::radians;
  if (!reads_as(parts->first, polar.magnitude) || !reads_as(angle, polar.angle) || polar.magnitude < 0.0) return std::nullopt;
  return polar;
}

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
