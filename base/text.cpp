#include "base/text.hpp"

#include <array>
#include <cstdio>

namespace jointid {
namespace {

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0xFFFFFFFF;  ///< beyond all characters where the byte is no UTF-8
};

Character first_character(std::string_view text) {
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {1, first};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 0;
  if (bytes == 0 || bytes > text.size()) return {};
  char32_t code = first & (0x7F >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  return code >= smallest[bytes] && code <= 0x10FFFF ? Character{bytes, code} : Character{};
}

bool turns_or_breaks_lines(char32_t code) {
  return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) ||
         code == 0xFEFF;
}

std::string escaped(const char* format, unsigned code) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, code);
  return text.data();
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character next = first_character(text);
    const bool control = next.code < 0x20 || (next.code >= 0x7F && next.code < 0xA0);
    if (next.code == U'\n') {
      shown += "\\n";
    } else if (next.code == U'\t') {
      shown += "\\t";
    } else if (control || next.code > 0x10FFFF) {
      shown += escaped("\\x%02X", control ? next.code : static_cast<unsigned char>(text[0]));
    } else if (turns_or_breaks_lines(next.code)) {
      shown += escaped("\\u%04X", next.code);
    } else {
      shown += text.substr(0, next.bytes);
    }
    text.remove_prefix(next.bytes);
  }
  return shown;
}

std::string digits(double value, const char* format) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string percent(double share) { return digits(100.0 * share, share < 0.1 ? "%.2g" : "%.0f") + " %"; }

std::string one_of(std::span<const std::string> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace jointid
