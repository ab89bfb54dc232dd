#include "frf/text/label_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

constexpr std::array signs = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"⁻", "^-"},    {"⁰", "^0"}, {"¹", "^1"}, {"²", "^2"}, {"³", "^3"},     {"⁴", "^4"},  // powers
    {"·", "*"},     {"⋅", "*"},  {"×", "*"},  {"•", "*"},  {"∙", "*"},      {"∗", "*"},      {"⸱", "*"},      {"∕", "/"},
    {"⁄", "/"},     {"÷", "/"},  {"−", "-"},  {"–", "-"},  {"‐", "-"},      {"‑", "-"},      {"µ", "u"},      {"μ", "u"},
    {"°", "deg"},   {"’", "'"},  {"´", "'"},  {"`", "'"},  {"\u00A0", " "}, {"\u202F", " "}, {"\u2009", " "}, {"\u3000", " "},
    {"\uFEFF", ""}, {"[", "("},  {"{", "("},  {"]", ")"},  {"}", ")"},      {"\t", " "},
});

/// Bytes of DOS code pages as the letters of Latin-1 that are in no unit: ² ³ µ ° ·.
constexpr std::array dos_signs = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"ý", "^2"}, {"ü", "^3"}, {"æ", "u"}, {"ø", "deg"}, {"ú", "*"}});

/// Pieces of ASCII that mean one sign or one word, in lower case.
constexpr std::array pieces = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"**", "^"},         {"^-^", "^-"},       {"^^", "^"},         {"pk-pk", "pkpk"},   {"p-p", "pp"},      {"0-peak", "pk"},
     {"0-pk", "pk"},      {"0-p", "pk"},       {"-force", "force"}, {" force", "force"}, {", rms", " rms"},  {", pk", " pk"},
     {", peak", " pk"},   {"lb-f", "lbf"},     {"lb(f)", "lbf"},    {"lb (f)", "lbf"},   {"lb_f", "lbf"},    {"lb f", "lbf"},
     {"kg-f", "kgf"},     {"kg(f)", "kgf"},    {"kg (f)", "kgf"},   {"kg_f", "kgf"},     {"kg f", "kgf"},    {"milli-", "milli"},
     {"micro-", "micro"}, {"ms^-2", "m*s^-2"}, {"ms-2", "m*s^-2"},  {"ms^-1", "m*s^-1"}, {"ms-1", "m*s^-1"}, {"g0", "gn"}});

std::string_view sign_of(std::string_view sequence) {
  const auto is_it = [&](const auto& sign) { return sign.first == sequence; };
  if (const auto found = std::ranges::find_if(signs, is_it); found != signs.end()) return found->second;
  const auto found = std::ranges::find_if(dos_signs, is_it);
  return found != dos_signs.end() ? found->second : sequence;
}

void replace_pieces(std::string& text) {
  for (const auto& [from, to] : pieces) {
    for (std::size_t at = lower_case(text).find(from); at != std::string::npos; at = lower_case(text).find(from)) {
      text.replace(at, from.size(), to);
    }
  }
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  return std::ranges::all_of(text.substr(1, length - 1), follows) ? length : 0;
}

std::string_view without_padding(std::string_view label) {
  const auto is_padding = [](unsigned char c) { return c <= ' ' || c == 0x7F; };
  const auto trim = [&] {
    while (!label.empty() && is_padding(static_cast<unsigned char>(label.front()))) label.remove_prefix(1);
    while (!label.empty() && is_padding(static_cast<unsigned char>(label.back()))) label.remove_suffix(1);
  };
  trim();
  label = label.substr(0, label.find('\0'));
  trim();
  const bool quoted = label.size() > 1 && (label.front() == '"' || label.front() == '\'') && label.back() == label.front();
  if (quoted) label = label.substr(1, label.size() - 2);
  trim();
  return label;
}

std::string_view without_brackets(std::string_view label) {
  const bool both =
      label.size() > 1 && ((label.front() == '[' && label.back() == ']') || (label.front() == '(' && label.back() == ')'));
  const bool around = both && label.find_first_of("])") == label.size() - 1;
  return around ? without_padding(label.substr(1, label.size() - 2)) : label;
}

std::vector<std::string_view> labels_in(std::string_view text) {
  std::vector<std::string_view> labels = {text};
  const std::size_t square = text.find_last_of('['), round = text.find(" ("), sign = text.find_last_of(":=");
  if (square != std::string_view::npos && text.ends_with(']'))
    labels.push_back(text.substr(square + 1, text.size() - square - 2));
  if (round != std::string_view::npos && text.ends_with(')')) labels.push_back(text.substr(round + 1));
  if (sign != std::string_view::npos) labels.push_back(text.substr(sign + 1));
  return labels;
}

std::vector<std::string_view> ratios_in(std::string_view text) {
  constexpr std::string_view blanks = " \t", around = ".,;:!?\"'";
  std::vector<std::string_view> ratios;
  if (const std::size_t in = text.rfind(" in "); in != std::string_view::npos) {
    std::string_view rest = text.substr(in + 4);
    rest = rest.substr(0, rest.find_first_of(",;"));
    while (!rest.empty() && rest.back() == '.') rest.remove_suffix(1);
    ratios.push_back(rest);
  }
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    std::string_view word = text.substr(begin, end - begin);
    while (!word.empty() && around.find(word.back()) != std::string_view::npos) word.remove_suffix(1);
    while (!word.empty() && around.find(word.front()) != std::string_view::npos) word.remove_prefix(1);
    if (word.find('/') != std::string_view::npos) ratios.push_back(without_brackets(word));
    begin = text.find_first_not_of(blanks, end);
  }
  return ratios;
}

void append_utf8(std::string& out, std::uint32_t code) {
  constexpr std::uint32_t last_character = 0x10FFFF;
  const auto add = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  const auto follow = [&](std::uint32_t shift) { add(0x80U | ((code >> shift) & 0x3FU)); };
  if ((code >= 0xD800 && code < 0xE000) || code > last_character) {
    add('?');
  } else if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6U)), follow(0);
  } else if (code < 0x10000) {
    add(0xE0U | (code >> 12U)), follow(6), follow(0);
  } else {
    add(0xF0U | (code >> 18U)), follow(12), follow(6), follow(0);
  }
}

std::string utf8_label(std::string_view label) {
  if (is_utf8(label)) return std::string(label);
  std::string text;
  for (const char each : label) {
    const auto c = static_cast<unsigned char>(each);
    if (c >= 0x80) text += static_cast<char>(0xC0 | (c >> 6));
    text += static_cast<char>(c < 0x80 ? c : 0x80 | (c & 0x3F));
  }
  return text;
}

std::string plain_label(std::string_view label) {
  const std::string_view bare = without_padding(label);
  const std::string text = utf8_label(bare);
  std::string plain;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view sequence = rest.substr(0, std::max<std::size_t>(1, utf8_length(rest)));
    rest.remove_prefix(sequence.size());
    const bool converted_twice =
        sequence == "Â" && !rest.empty() && sign_of(rest.substr(0, utf8_length(rest))) != rest.substr(0, utf8_length(rest));
    if (!converted_twice) plain += sign_of(sequence);
  }
  replace_pieces(plain);
  return plain;
}

}  // namespace jointid::frf
