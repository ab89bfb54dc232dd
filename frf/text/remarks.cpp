#include "frf/text/remarks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using NameWords = std::vector<std::string>;

bool is_lower_letter(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper_letter(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// "scale", "factor" of "ScaleFactor", "scale_factor" and "SCALE FACTOR".
NameWords words_of_name(std::string_view name) {
  NameWords words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool letter = std::isalpha(static_cast<unsigned char>(name[i])) != 0;
    const bool begins = letter && is_upper_letter(name[i]) && i > 0 && is_lower_letter(name[i - 1]);
    if ((begins || !letter) && !words.back().empty()) words.emplace_back();
    if (letter) words.back() += lower_case(name.substr(i, 1));
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

template <std::size_t Size>
bool has_one_word(const NameWords& words, const std::array<std::string_view, Size>& wanted) {
  return std::ranges::any_of(words, [&](const std::string& word) { return std::ranges::find(wanted, word) != wanted.end(); });
}

/// "yscale", "calibrated", "sensitivities".
template <std::size_t Size>
bool has_part_of(const NameWords& words, const std::array<std::string_view, Size>& wanted) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::any_of(wanted, [&](std::string_view part) { return word.find(part) != std::string::npos; });
  });
}

constexpr std::array<std::string_view, 9> parts_of_factors = {"scale",    "scaling", "calib",   "sensitiv", "multipl",
                                                              "amplific", "attenua", "convers", "normali"};
constexpr std::array<std::string_view, 8> words_of_factors = {"gain", "gains", "cal", "sens", "factor", "factors", "lsb", "sign"};
/// Of what else there are scales and factors.
constexpr std::array<std::string_view, 28> of_others = {
    "loss", "damping", "quality", "crest", "safety", "fill",  "form",    "plot",     "axis",  "time",  "x",     "freq", "frequency",
    "window", "overlap", "shape", "mode", "modal", "color", "colour", "display", "colormap", "modes", "noise", "power",
    "load", "full", "auto"};

/// In lower case without what formulas may have more of, "e-iwt" of "e^{-iwt}".
std::string without_signs(std::string_view text, std::string_view signs) {
  std::string plain = lower_case(text);
  std::erase_if(plain, [&](char c) { return signs.find(c) != std::string_view::npos; });
  return plain;
}

/// What stands behind a sign of multiplication at the beginning of a word, "1000" of "x1000"; empty where there is none.
std::string_view behind_times(std::string_view word) {
  for (const std::string_view sign : {"x", "*", "×"}) {
    if (word.starts_with(sign)) return word.substr(sign.size());
  }
  return {};
}

/// The power of ten that a word multiplies by, "x1000" and "×10^-6"; of 10 and 0.1 only where an exponent or a point shows it.
std::optional<double> power_of_ten(std::string_view word) {
  std::string number(behind_times(word));
  if (number.starts_with("10^")) number.replace(0, 3, "1e");
  double value = 0.0;
  if (number.empty() || !parse_cell(number, false, value) || !(value > 0.0)) return std::nullopt;
  const double decades = std::log10(value), least = number.find_first_of("e.") != std::string::npos ? 1.0 : 2.0;
  return decades == std::round(decades) && std::abs(decades) >= least ? std::optional(value) : std::nullopt;
}

}  // namespace

NumberUse use_of_number(std::string_view name) {
  const NameWords words = words_of_name(name);
  constexpr std::array<std::string_view, 2> added = {"offset", "bias"};
  if (has_one_word(words, of_others)) return NumberUse::none;
  if (has_one_word(words, added)) return NumberUse::is_added;
  const bool to_si = words == NameWords{"to", "si"} || words == NameWords{"tosi"};
  constexpr std::array<std::string_view, 7> electrical = {"v", "mv", "volt", "volts", "eu", "pc", "counts"};
  const bool sensitivity = std::ranges::find(words, "per") != words.end() && has_one_word(words, electrical);
  const bool factor = to_si || sensitivity || has_part_of(words, parts_of_factors) || has_one_word(words, words_of_factors);
  return factor ? NumberUse::multiplies : NumberUse::none;
}

bool is_of_something_else(std::string_view name) {
  constexpr std::array<std::string_view, 12> parts = {"conj",     "impedance", "stiff", "inverse", "transmissib", "transpos",
                                                      "residual", "error",     "deriv", "_mass",   "normali",     "squared"};
  constexpr std::array<std::string_view, 13> words = {"inv",   "err", "db",   "sq", "log", "diff", "delta",
                                                      "std",   "norm", "ln",  "dif", "t",  "var"};
  constexpr std::array<std::string_view, 14> whole = {"z",  "zj", "hinv", "invh", "ht",   "hh", "hstar",
                                                      "dh", "lnh", "logh", "hlog", "hdb", "hsq", "deltah"};
  const std::string plain = lower_case(name);
  NameWords split(1);
  for (const char c : plain) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) split.back() += c;
    else split.emplace_back();
  }
  const auto inside = [&](std::string_view part) { return plain.find(part) != std::string::npos; };
  const bool by_word = split.size() > 1 && has_one_word(split, words);
  return std::ranges::any_of(parts, inside) || by_word || std::ranges::find(whole, plain) != whole.end();
}

std::optional<double> factor_in_title(std::string_view title) {
  constexpr std::string_view between = " \t()[]";
  for (std::size_t begin = title.find_first_not_of(between); begin != std::string_view::npos;) {
    const std::size_t end = std::min(title.find_first_of(between, begin), title.size());
    if (const auto factor = power_of_ten(lower_case(title.substr(begin, end - begin)))) return factor;
    begin = title.find_first_not_of(between, end);
  }
  return std::nullopt;
}

std::optional<double> stated_factor(std::string_view text) {
  const std::string plain = lower_case(text);
  for (const std::string_view sign : {"multiplied by ", "multiply by ", "multiply with ", "scaled by ", "divided by ", "divide by ",
                                      "values x ", "values x"}) {
    const std::size_t at = plain.find(sign);
    if (at == std::string::npos) continue;
    const std::string_view rest = trimmed(std::string_view(plain).substr(at + sign.size()));
    double value = 0.0;
    std::string_view word = rest.substr(0, rest.find_first_of(" ,;)]"));
    if (!word.empty() && parse_cell(word, false, value)) return value;
  }
  std::string_view word = trimmed(plain);
  while (!word.empty() && (word.front() == '(' || word.front() == '[')) word.remove_prefix(1);
  while (!word.empty() && (word.back() == ')' || word.back() == ']')) word.remove_suffix(1);
  double value = 0.0;
  const std::string_view number = trimmed(behind_times(word));
  return !number.empty() && parse_cell(number, false, value) ? std::optional(value) : std::nullopt;
}

bool states_conjugates(std::string_view text) {
  const std::string plain = without_signs(text, " \t{}()[]^*\\_"), spaced = without_signs(text, "{}()[]^*\\_");
  for (const std::string_view sign : {"exp-i", "exp-j", "exp-1i", "exp-1j", "exp−i", "exp−j"}) {
    if (plain.find(sign) != std::string::npos) return true;
  }
  for (const std::string_view sign : {"e-iw", "e-jw", "e-iω", "e-jω", "e-iomega", "e-jomega"}) {
    const std::size_t at = spaced.find(sign);
    if (at != std::string::npos && (at == 0 || std::isalpha(static_cast<unsigned char>(spaced[at - 1])) == 0)) return true;
  }
  return plain.find("conjugat") != std::string::npos && plain.find("notconjugat") == std::string::npos;
}

}  // namespace jointid::frf
