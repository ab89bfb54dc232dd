#include "frf/text/proposed_dof.hpp"

#include <algorithm>
#include <cctype>

#include "frf/text/direction_names.hpp"

namespace jointid::frf {
namespace {

/// In capitals, without blanks, quotes and underscores, with a plain minus sign.
std::string plain_dof(std::string_view text) {
  constexpr std::string_view minus = "\u2212";
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with(minus)) {
      plain += '-';
      i += minus.size() - 1;
    } else if (std::string_view(" \t_\"'").find(text[i]) == std::string_view::npos) {
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(text[i])));
    }
  }
  return plain;
}

/// Takes the longest beginning of `rest` that consists of `letters`.
std::string_view take_any(std::string_view& rest, std::string_view letters) {
  const std::string_view taken = rest.substr(0, std::min(rest.find_first_not_of(letters), rest.size()));
  rest.remove_prefix(taken.size());
  return taken;
}

/// "X" of "X", and of 1, its code in UFF; empty for anything else.
std::string_view direction_of(std::string_view word) {
  for (std::size_t i = 0; i < direction_names.size(); ++i) {
    if (word == direction_names[i] || (word.size() == 1 && word[0] == static_cast<char>('1' + i))) return direction_names[i];
  }
  return {};
}

/// Without words before it ("FRF 12X+"), and without the name of a component ("plate:12:+X").
std::string_view without_component(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (const std::size_t blank = text.rfind(' '); blank != std::string_view::npos) {
    const std::string_view last = text.substr(blank + 1);
    if (last.find_first_of("0123456789") != std::string_view::npos && last.find_first_of("XYZxyz") != std::string_view::npos) text = last;
  }
  const std::size_t colon = text.find(':');
  const bool named = colon != std::string_view::npos && text.find(':', colon + 1) != std::string_view::npos &&
                     text.substr(0, colon).find_first_not_of("0123456789") != std::string_view::npos;
  return named ? text.substr(colon + 1) : text;
}

}  // namespace

std::string proposed_dof(std::string_view text) {
  constexpr std::size_t longest = 40;
  const std::string plain = plain_dof(without_component(text.substr(0, longest)));
  std::string_view rest = plain;
  take_any(rest, "ABCDEFGHIJKLMNOPQRSTUVWXYZ");  // Pt, Node, DOF
  const std::string_view node = take_any(rest, "0123456789");
  const bool apart = !take_any(rest, ":.,;/").empty();
  const std::string_view before = take_any(rest, "+-");
  const std::string_view word = take_any(rest, apart ? "RXYZ123456" : "RXYZ");
  const std::string_view after = take_any(rest, "+-"), direction = direction_of(word);
  if (node.empty() || node.size() > 10 || direction.empty() || !rest.empty() || before.size() + after.size() > 1) return {};
  const bool negative = before == "-" || after == "-";
  return std::string(node) + (negative ? ":-" : ":+") + std::string(direction);
}

}  // namespace jointid::frf
