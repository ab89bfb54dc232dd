#include "frf/csv/csv_functions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using Words = std::pair<std::string_view, std::string_view>;

/// What stands before the name of an FRF, in lower case, and the part that it is.
constexpr std::array functions = std::to_array<Words>({{"re", "re"},
                                                       {"real", "re"},
                                                       {"ℜ", "re"},
                                                       {"im", "im"},
                                                       {"imag", "im"},
                                                       {"ℑ", "im"},
                                                       {"abs", "mag"},
                                                       {"mag", "mag"},
                                                       {"magnitude", "mag"},
                                                       {"mod", "mag"},
                                                       {"betrag", "mag"},
                                                       {"arg", "phase"},
                                                       {"angle", "phase"},
                                                       {"phase", "phase"},
                                                       {"ph", "phase"},
                                                       {"coh", "coherence"},
                                                       {"coherence", "coherence"},
                                                       {"∠", "phase"}});

/// Whole titles in lower case.
constexpr std::array titles = std::to_array<Words>({{"modulus", "mag"},
                                                    {"module", "mag"},
                                                    {"modulo", "mag"},
                                                    {"módulo", "mag"},
                                                    {"absolute value", "mag"},
                                                    {"argument", "phase"},
                                                    {"arg", "phase"},
                                                    {"phi", "phase"},
                                                    {"φ", "phase"},
                                                    {"ϕ", "phase"},
                                                    {"fase", "phase"},
                                                    {"phase angle", "phase"},
                                                    {"phasenwinkel", "phase"},
                                                    {"phasenlage", "phase"},
                                                    {"ph", "phase"},
                                                    {"ph.", "phase"},
                                                    {"partie réelle", "re"},
                                                    {"partie imaginaire", "im"},
                                                    {"parte reale", "re"},
                                                    {"parte immaginaria", "im"},
                                                    {"parte real", "re"},
                                                    {"parte imaginaria", "im"},
                                                    {"parte imaginária", "im"},
                                                    {"angle", "phase"},
                                                    {"位相", "phase"},
                                                    {"相位", "phase"}});

bool may_be_unit(std::string_view text) { return parse_unit(text) || !unit_hint(text).empty(); }

bool is_angle(std::string_view text) {
  const auto unit = parse_unit(text);
  return is_degrees(text) || is_radians(text) || lower_case(text) == "grad" || (unit && unit->same_dimension({1.0, 0, 0, 0, 1}));
}

bool is_level(std::string_view text) {
  const std::string plain = lower_case(text);
  return plain == "db" || plain.starts_with("db ");
}

bool opens(char c) { return c == '(' || c == '[' || c == '{'; }
bool closes(char c) { return c == ')' || c == ']' || c == '}'; }

/// "|H|", "arg(H)", "Re H11".
bool is_function(std::string_view text) {
  const bool enclosed = text.size() > 1 && (text.back() == '|' || closes(text.back()));
  return (enclosed && function_as_part(text, true) != text) || is_csv_part(text.substr(0, text.find(' ')));
}

/// What stands between brackets or strokes that end the title and begin at `open`; empty where these are not the only ones.
std::string_view enclosed_from(std::string_view title, std::size_t open) {
  if (title.size() < open + 3) return {};
  const std::string_view inside = title.substr(open + 1, title.size() - open - 2);
  if (title[open] == '|') return title.back() == '|' && inside.find('|') == std::string_view::npos ? inside : std::string_view();
  int depth = 1;
  for (const char c : inside) {
    depth += opens(c) ? 1 : closes(c) ? -1 : 0;
    if (depth == 0) return {};
  }
  const char close = title[open] == '(' ? ')' : title[open] == '[' ? ']' : '}';
  return depth == 1 && title.back() == close ? inside : std::string_view();
}

std::string with_part(std::string_view name, std::string_view part) { return std::string(trimmed(name)) + " " + std::string(part); }

}  // namespace

std::optional<CsvTitle> quantity_over_unit(std::string_view cell) {
  int depth = 0;
  bool stroke = false;
  for (std::size_t at = 0; at < cell.size(); ++at) {
    depth += opens(cell[at]) ? 1 : closes(cell[at]) ? -1 : 0;
    if (cell[at] == '|') stroke = !stroke;
    const bool in = cell.substr(at).starts_with(" in "), bar = cell.substr(at).starts_with(" | ");
    if (depth != 0 || (stroke && !bar) || at == 0 || (cell[at] != '/' && !in && !bar)) continue;
    const std::string_view before = trimmed(cell.substr(0, at)), unit = trimmed(cell.substr(at + (in ? 4 : bar ? 3 : 1)));
    if (before.empty() || unit.empty()) continue;
    const bool known = quantity_of_unit(unit) || is_angle(unit) || is_level(unit);
    const bool enclosed = opens(unit.front()) && !enclosed_from(unit, 0).empty();
    if (known || (enclosed && is_function(before))) return CsvTitle{std::string(before), std::string(without_brackets(unit))};
  }
  return std::nullopt;
}

std::string function_as_part(std::string_view title, bool unit_known) {
  const std::string plain = lower_case(title);
  if (const auto whole = std::ranges::find(titles, plain, &Words::first); whole != titles.end()) return std::string(whole->second);
  if (const std::size_t open = title.rfind('('); open > 0 && open < title.size() && title.ends_with(')')) {
    const std::string_view inside = title.substr(open + 1, title.size() - open - 2);  // "FRF (Magnitude)"
    if (is_csv_part(inside) && title[open - 1] == ' ') return with_part(title.substr(0, open), inside);
  }
  if (const std::string_view inside = enclosed_from(title, 0); title.starts_with('|') && !inside.empty())
    return with_part(inside, "mag");
  for (const auto& [name, part] : functions) {
    if (!plain.starts_with(name)) continue;
    const std::string_view rest = title.substr(name.size());
    const bool sign = static_cast<unsigned char>(name.front()) >= 0x80;
    if (sign && !rest.empty() && rest.find_first_of("[(") == std::string_view::npos) return with_part(rest, part);
    if (rest.empty() || !opens(rest.front())) continue;
    const std::string_view inside = enclosed_from(rest, 0);
    if (!inside.empty() && (unit_known || !may_be_unit(inside))) return with_part(inside, part);
  }
  return std::string(title);
}

std::string part_behind_sign(std::string_view title) {
  const std::string plain = lower_case(title);
  if (plain.ends_with(" phase angle")) return std::string(title.substr(0, title.rfind(' ')));
  const std::size_t sign = title.find_last_of("/;|,-");
  if (sign == std::string_view::npos || is_csv_part(title)) return std::string(title);
  const std::string_view name = trimmed(title.substr(0, sign)), part = trimmed(title.substr(sign + 1));
  const bool open = !name.empty() && is_csv_part(part) && !is_csv_part(name.substr(name.rfind(' ') + 1));
  return open ? with_part(name, part) : std::string(title);
}

std::string joined_part(std::string_view title) {
  if (title.find_first_of(" (") != std::string_view::npos) return std::string(title);
  for (std::size_t at = title.find_first_of("_."); at != std::string_view::npos; at = title.find_first_of("_.", at + 1)) {
    const std::string_view first = title.substr(0, at), last = title.substr(at + 1);
    if (!first.empty() && is_csv_part(last) && !may_be_unit(first)) return with_part(first, last);
    if (!last.empty() && is_csv_part(first) && !is_csv_part(title) && !may_be_unit(last) && csv_part(first) != csv_part(title))
      return with_part(last, first);
  }
  return std::string(title);
}

namespace {

/// The name of the FRF of a title that begins or ends with a word for its part; empty where it does not, or has no other letters.
std::string without_word(const std::string& title, std::string_view word, bool at_end) {
  const std::string plain = lower_case(title);
  if (plain.size() <= word.size() || !(at_end ? plain.ends_with(word) : plain.starts_with(word))) return {};
  return at_end ? title.substr(0, title.size() - word.size()) : title.substr(word.size());
}

/// "H", "FRF" and "H11", behind which r and i alone are parts.
bool is_short_name(std::string_view name) {
  const std::string plain = lower_case(name.substr(0, name.find_first_of("0123456789")));
  return plain.size() == 1 || plain == "frf";
}

}  // namespace

void pair_parts(std::vector<std::string>& titles) {
  struct PartWords {
    std::string_view re, im;
    bool at_end;
  };
  constexpr std::array words = std::to_array<PartWords>(
      {{"_r", "_i", true}, {".r", ".i", true}, {"real", "imag", true}, {"real", "imaginary", true}, {"re", "im", true},
       {"real", "imag", false}, {"real", "imaginary", false}, {"re", "im", false}, {"r", "i", true}});
  const auto is_open = [](const std::string& title) {
    return title.find_first_of(" (:/") == std::string::npos && !is_csv_part(title);
  };
  for (std::string& real : titles) {
    for (const PartWords& each : words) {
      const std::string name = is_open(real) ? without_word(real, each.re, each.at_end) : std::string();
      if (name.empty() || (each.re == "r" && !is_short_name(name))) continue;
      const auto imaginary = std::ranges::find_if(titles, [&](const std::string& title) {
        return is_open(title) && without_word(title, each.im, each.at_end) == name;
      });
      if (imaginary == titles.end()) continue;
      real = with_part(name, "re"), *imaginary = with_part(name, "im");
      break;
    }
  }
}

std::string_view other_quantity(std::string_view label) {
  constexpr std::array others = std::to_array<Words>({{"stiffness", "a dynamic stiffness"},
                                                      {"steifigkeit", "a dynamic stiffness"},
                                                      {"impedan", "an impedance"},
                                                      {"impédance", "an impedance"},
                                                      {"apparentmass", "an apparent mass"},
                                                      {"dynamicmass", "an apparent mass"},
                                                      {"effectivemass", "an apparent mass"},
                                                      {"transmissib", "a transmissibility"},
                                                      {"autospec", "a spectrum"},
                                                      {"autopower", "a spectrum"},
                                                      {"crossspec", "a spectrum"},
                                                      {"crosspower", "a spectrum"},
                                                      {"powerspec", "a spectrum"},
                                                      {"leistungsspek", "a spectrum"}});
  std::string plain = lower_case(label);
  std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-'; });
  const auto found = std::ranges::find_if(others, [&](const Words& each) { return plain.find(each.first) != std::string::npos; });
  return found != others.end() ? found->second : std::string_view();
}

bool says_complex(std::string_view text) {
  std::string plain = lower_case(text);
  std::erase(plain, ' ');
  constexpr std::array<std::string_view, 10> words = {"mag∠phase", "abs∠arg", "polar",  "complex", "re+im",
                                                      "re+j*im",   "re+jim",  "re+i*im", "a+bj",   "a+bi"};
  return std::ranges::find(words, plain) != words.end();
}

std::string_view other_function(std::string_view label) {
  std::string plain = lower_case(label);
  std::erase(plain, ' ');
  const auto has = [&](std::string_view piece) { return plain.find(piece) != std::string::npos; };
  if (has("conj") || plain.ends_with('*')) return "the conjugate";
  const bool over = plain.starts_with("1/") && plain.size() > 2 && (plain[2] < '0' || plain[2] > '9');
  if (over || has("inv(") || has("^-1") || has("⁻¹")) return "the inverse";
  const bool minus = plain == "neg" || plain == "neg." || plain == "negative" || plain == "minus" || plain == "-" || has("invert");
  if (plain == "lag" || plain == "delay" || has("phaselag") || minus) return "the negative";
  if (has("normali") || has("normiert")) return "the normalised value";
  if (has("log")) return "the logarithm";
  return has("^2") || has("²") || has("squared") ? "the square" : std::string_view();
}

}  // namespace jointid::frf
