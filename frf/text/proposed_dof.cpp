#include "frf/text/proposed_dof.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

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
    if (last.find_first_of("0123456789") != std::string_view::npos && last.find_first_of("XYZxyz") != std::string_view::npos)
      text = last;
  }
  const std::size_t colon = text.find(':'), dot = text.substr(0, colon).rfind('.');
  if (colon != std::string_view::npos && dot != std::string_view::npos &&
      std::isalpha(static_cast<unsigned char>(text.front())) != 0)
    return text.substr(dot + 1);  // "Assembly.21:+Z"
  const bool named = colon != std::string_view::npos && text.find(':', colon + 1) != std::string_view::npos &&
                     text.substr(0, colon).find_first_not_of("0123456789") != std::string_view::npos;
  return named ? text.substr(colon + 1) : text;
}

/// A word of a name in capitals, and where it begins.
struct NameWord {
  std::string_view text;
  std::size_t at;
};

std::vector<NameWord> name_words(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::vector<NameWord> words;
  for (std::size_t at = name.find_first_of(letters); at != std::string_view::npos;) {
    const std::size_t end = std::min(name.find_first_not_of(letters, at), name.size());
    words.push_back({name.substr(at, end - at), at});
    at = name.find_first_of(letters, end);
  }
  return words;
}

/// "PART-1-1" of Abaqus, letters and then numbers behind dashes: blanks in its place.
std::string without_instance(std::string name) {
  for (std::size_t dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 1)) {
    std::size_t begin = dash, end = dash;
    while (begin > 0 && (std::isalnum(static_cast<unsigned char>(name[begin - 1])) != 0)) --begin;
    while (end < name.size() && (name[end] == '-' || std::isdigit(static_cast<unsigned char>(name[end])) != 0)) ++end;
    const bool named = begin < dash && std::isalpha(static_cast<unsigned char>(name[begin])) != 0;
    if (named && end > dash + 1) name.replace(begin, end - begin, end - begin, ' ');
  }
  return name;
}

/// The direction of "U3", "UR1", "T2", "R3", "UZ", "DX", "ROTX"; empty for anything else.
std::string_view direction_of_component(std::string_view word) {
  constexpr std::array<std::string_view, 6> rotations = {"ROT", "UR", "VR", "AR", "TR", "R"};
  constexpr std::array<std::string_view, 5> translations = {"U", "T", "D", "V", "A"};
  constexpr std::string_view axes = "XYZ123";
  const std::size_t axis = word.size() > 1 ? axes.find(word.back()) % 3 : 3;
  if (word.size() < 2 || axes.find(word.back()) == std::string_view::npos) return {};
  word.remove_suffix(1);
  if (std::ranges::find(rotations, word) != rotations.end()) return direction_names[axis + 3];
  return std::ranges::find(translations, word) != translations.end() ? direction_names[axis] : std::string_view();
}

/// The number of "21", "N21", "NODE21" and "GRID21"; empty for anything else.
std::string_view node_of_word(std::string_view word) {
  for (const std::string_view name : {"NODE", "GRID", "N"}) {
    if (!word.starts_with(name)) continue;
    word.remove_prefix(name.size());
    break;
  }
  return word.size() <= 10 && word.find_first_not_of("0123456789") == std::string_view::npos ? word : std::string_view();
}

/// Names of finite-element programs, one node and one component: "PART-1-1.21:U3", "21:T3", "U3 at node 21", "GRID 21 COMP 3".
std::string dof_of_program(std::string_view text) {
  std::string name(text);
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  name = without_instance(std::move(name));
  std::string_view node, direction, before;
  bool negative = false;
  for (const NameWord& word : name_words(name)) {
    std::string_view component = direction_of_component(word.text);
    if (before == "COMP" || before == "COMPONENT" || before == "DOF") component = direction_of(word.text);
    before = word.text;
    const std::string_view number = component.empty() ? node_of_word(word.text) : std::string_view();
    if ((!component.empty() && !direction.empty()) || (!number.empty() && !node.empty())) return {};
    if (!number.empty()) node = number;
    if (component.empty()) continue;
    direction = component;
    const bool minus = word.at > 0 && name[word.at - 1] == '-';
    if (minus && (word.at < 2 || std::isalnum(static_cast<unsigned char>(name[word.at - 2])) != 0)) return {};  // or a dash
    negative = minus || name.substr(word.at + word.text.size()).starts_with('-');
  }
  if (node.empty() || direction.empty()) return {};
  return std::string(node) + (negative ? ":-" : ":+") + std::string(direction);
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
  if (node.empty() || node.size() > 10 || direction.empty() || !rest.empty() || before.size() + after.size() > 1)
    return dof_of_program(text.substr(0, longest));
  const bool negative = before == "-" || after == "-";
  return std::string(node) + (negative ? ":-" : ":+") + std::string(direction);
}

}  // namespace jointid::frf
