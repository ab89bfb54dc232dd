#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace jointid {

/// A number by a printf format of one double.
std::string digits(double value, const char* format = "%.2g");

/// "3.2 %" of 0.032, "41 %" of 0.412.
std::string percent(double share);

/// "a, b, c" of what `word` makes of each item.
template <typename Items, typename Word = std::identity>
std::string comma_list(const Items& items, const Word& word = {}) {
  std::string text;
  bool first = true;
  for (const auto& item : items) {
    if (!first) text += ", ";
    text += std::invoke(word, item);
    first = false;
  }
  return text;
}

/// The text as a terminal may show it in one line: control characters, bytes that are no UTF-8 and characters that turn the direction of
/// writing come as \n, \t, \x1A, \u202E; all else stays.
std::string printable(std::string_view text);

/// "a, b or c".
std::string one_of(std::span<const std::string> words);

}  // namespace jointid
