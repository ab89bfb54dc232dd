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
    const bool letter = std::isalpha(static_cast<unsigned char>(name[i])) != 0 || static_cast<unsigned char>(name[i]) >= 0x80;
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

constexpr std::array<std::string_view, 18> parts_of_factors = {
    "scale",   "scaling", "calib",     "sensitiv",    "multipl", "amplific",      "attenua",   "convers", "normali",
    "skalier", "faktor",  "kalibrier", "empfindlich", "facteur", "verst\u00E4rk", "verstaerk", "preamp",  "correction"};
constexpr std::array<std::string_view, 18> words_of_factors = {"gain", "gains",   "cal",    "sens", "factor", "factors",
                                                               "lsb",  "sign",    "ecf",    "acf",  "mult",   "fac",
                                                               "fact", "divisor", "divide", "conv", "sf",     "eu"};
/// Of what else there are scales and factors.
constexpr std::array<std::string_view, 28> of_others = {
    "loss",    "damping",  "quality",   "crest",  "safety",  "fill",  "form", "plot",  "axis",  "time",
    "x",       "freq",     "frequency", "window", "overlap", "shape", "mode", "modal", "color", "colour",
    "display", "colormap", "modes",     "noise",  "power",   "load",  "full", "auto"};

/// Of channels, one each or one of all.
constexpr std::array<std::string_view, 15> words_of_channel_factors = {"amp",    "amps",    "ampl",  "amplitude", "amplitudes",
                                                                       "weight", "weights", "coeff", "coef",      "norm",
                                                                       "norms",  "ref",     "slope", "corr",      "sensor"};
/// Of sampling, lines, models, places and conditions of a test.
constexpr std::array harmless_words = std::to_array<std::string_view>(
    {"fs",        "rate",    "sampling",   "sample",    "df",          "dt",          "delta",      "nfft",      "fft",
     "n",         "nf",      "nr",         "nc",        "ni",          "no",          "nres",       "nref",      "count",
     "number",    "num",     "nb",         "len",       "length",      "size",        "block",      "blocksize", "lines",
     "line",      "average", "avg",        "navg",      "naverage",    "f",           "fmin",       "fmax",      "fc",
     "fn",        "wn",      "freq",       "frequency", "frequencies", "omega",       "w",          "t",         "time",
     "zeta",      "eta",     "xi",         "damping",   "loss",        "mode",        "modal",      "pole",      "mass",
     "masses",    "m",       "stiffness",  "inertia",   "temp",        "temperature", "date",       "year",      "month",
     "day",       "hour",    "minute",     "version",   "id",          "run",         "test",       "index",     "idx",
     "torque",    "preload", "overlap",    "window",    "tau",         "x",           "y",          "z",         "pos",
     "position",  "coord",   "coordinate", "xyz",       "node",        "dof",         "channel",    "point",     "distance",
     "radius",    "height",  "width",      "thickness", "area",        "volume",      "rho",        "density",   "e",
     "young",     "poisson", "nu",         "seed",      "order",       "bandwidth",   "resolution", "snr",       "noise",
     "sigma",     "std",     "variance",   "humidity",  "pressure",    "dir",         "direction",  "type",      "spec",
     "case",      "step",    "start",      "end",       "stop",        "hammer",      "tip",        "bit",       "bits",
     "valid",     "flag",    "mask",       "status",    "serial",      "timestamp",   "duration",   "trigger",   "delay",
     "coherence", "coh"});

/// In lower case without what formulas may have more of, "e-iwt" of "e^{-iwt}".
std::string without_signs(std::string_view text, std::string_view signs) {
  std::string plain = lower_case(text);
  std::erase_if(plain, [&](char c) { return signs.find(c) != std::string_view::npos; });
  return plain;
}

/// "m_per_in", "volt_to_g": a unit into another.
bool is_conversion(const NameWords& words) {
  constexpr std::array<std::string_view, 10> units = {"m", "mm", "in", "inch", "n", "lbf", "g", "v", "volt", "volts"};
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i - 1] != "to" && words[i - 1] != "per") continue;
    if (std::ranges::find(units, words[i]) != units.end()) return true;
  }
  return false;
}

/// "eufactor", "kfactor", but no "lossfactor".
bool ends_in_factor(const NameWords& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    if (!word.ends_with("factor") && !word.ends_with("factors")) return false;
    return std::ranges::none_of(of_others, [&](std::string_view other) { return other.size() > 3 && word.starts_with(other); });
  });
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

/// Whether a text has a number other than 0 and 1 that is no year, behind words that are not of a date or a certificate.
bool states_other_number(std::string_view text) {
  constexpr std::string_view between = " \t,;:=()[]";
  constexpr std::array<std::string_view, 16> of_papers = {"date",   "valid",   "due",    "until",       "serial", "id",
                                                          "no",     "nr",      "type",   "certificate", "from",   "file",
                                                          "expire", "expires", "number", "model"};
  if (has_one_word(words_of_name(text), of_papers)) return false;
  bool found = false;
  for (std::size_t at = text.find_first_not_of(between); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    const std::string_view word = text.substr(at, end - at), number = word.substr(0, word.find_first_not_of("0123456789.,+-eE"));
    double value = 0.0;
    const bool is_number = !number.empty() && (parse_cell(number, false, value) || parse_cell(number, true, value));
    const bool year = value >= 1900.0 && value <= 2100.0 && value == std::floor(value);
    found = found || (is_number && value != 0.0 && value != 1.0 && !year);
    at = text.find_first_not_of(between, end);
  }
  return found;
}

/// "sensitivity: 100 mV/g" in lower case: of the sensor, which analysers apply.
bool is_of_sensor(std::string_view plain) {
  constexpr std::array<std::string_view, 5> electrical = {"mv/", "v/", "pc/", "mv per", "pc per"};
  return std::ranges::any_of(electrical, [&](std::string_view unit) { return plain.find(unit) != std::string_view::npos; });
}

}  // namespace

NumberUse use_of_number(std::string_view name) {
  const NameWords words = words_of_name(name);
  constexpr std::array<std::string_view, 2> added = {"offset", "bias"};
  if (has_one_word(words, of_others) && !has_one_word(words, std::array<std::string_view, 1>{"correction"}))
    return NumberUse::none;
  if (has_one_word(words, added)) return NumberUse::is_added;
  const bool to_si = words == NameWords{"to", "si"} || words == NameWords{"tosi"};
  constexpr std::array<std::string_view, 7> electrical = {"v", "mv", "volt", "volts", "eu", "pc", "counts"};
  const bool sensitivity = std::ranges::find(words, "per") != words.end() && has_one_word(words, electrical);
  const bool factor = to_si || sensitivity || is_conversion(words) || has_part_of(words, parts_of_factors) ||
                      has_one_word(words, words_of_factors) || ends_in_factor(words);
  return factor ? NumberUse::multiplies : NumberUse::none;
}

bool is_harmless_number(std::string_view name) {
  const NameWords words = words_of_name(name);
  const auto is_known = [](std::string_view word) { return std::ranges::find(harmless_words, word) != harmless_words.end(); };
  return has_one_word(words, of_others) || std::ranges::any_of(words, [&](std::string_view word) {
           const bool plural = word.size() > 3 && word.ends_with('s');
           return is_known(word) || (plural && is_known(word.substr(0, word.size() - 1)));
         });
}

bool may_be_channel_factor(std::string_view name) { return has_one_word(words_of_name(name), words_of_channel_factors); }

bool is_of_something_else(std::string_view name) {
  constexpr std::array<std::string_view, 12> parts = {"conj",     "impedance", "stiff", "inverse", "transmissib", "transpos",
                                                      "residual", "error",     "deriv", "_mass",   "normali",     "squared"};
  constexpr std::array<std::string_view, 13> words = {"inv", "err",  "db", "sq",  "log", "diff", "delta",
                                                      "std", "norm", "ln", "dif", "t",   "var"};
  constexpr std::array<std::string_view, 14> whole = {"z",  "zj",  "hinv", "invh", "ht",  "hh",  "hstar",
                                                      "dh", "lnh", "logh", "hlog", "hdb", "hsq", "deltah"};
  const std::string plain = lower_case(name);
  NameWords split(1);
  for (const char c : plain) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      split.back() += c;
    else
      split.emplace_back();
  }
  const auto inside = [&](std::string_view part) { return plain.find(part) != std::string::npos; };
  const bool by_word = split.size() > 1 && has_one_word(split, words);
  return std::ranges::any_of(parts, inside) || by_word || std::ranges::find(whole, plain) != whole.end();
}

std::optional<double> factor_in_title(std::string_view title) {
  constexpr std::string_view between = " \t()[]";
  bool times = false;
  for (std::size_t begin = title.find_first_not_of(between); begin != std::string_view::npos;) {
    const std::size_t end = std::min(title.find_first_of(between, begin), title.size());
    const std::string word = lower_case(title.substr(begin, end - begin));
    if (const auto factor = power_of_ten(times ? "x" + word : word)) return factor;
    for (const auto& [name, factor] : {std::pair{"milli", 1e-3}, {"micro", 1e-6}, {"kilo", 1e3}, {"thousandths", 1e-3}}) {
      if (word == name) return factor;
    }
    times = word == "x" || word == "*" || word == "×";
    begin = title.find_first_not_of(between, end);
  }
  return std::nullopt;
}

std::optional<double> stated_factor(std::string_view text) {
  const std::string plain = lower_case(text);
  for (const std::string_view sign :
       {"multiplied by ", "multiply by ", "multiply with ", "scaled by ", "divided by ", "divide by ", "values x ", "values x"}) {
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

bool states_sensitivity(std::string_view remark) {
  constexpr std::array<std::string_view, 4> parts = {"sensitiv", "calib", "kalibrier", "empfindlich"};
  constexpr std::array<std::string_view, 2> whole = {"sens", "cal"};
  constexpr std::array<std::string_view, 2> volts = {"volt", "volts"};
  const NameWords words = words_of_name(remark);
  const std::string plain = lower_case(trimmed(remark));
  if (has_one_word(words, volts) || plain.ends_with(" in v") || plain.ends_with(" in mv")) return true;
  return (has_part_of(words, parts) || has_one_word(words, whole) || is_of_sensor(plain)) && states_other_number(remark);
}

bool doubts_numbers(std::string_view remark) {
  constexpr std::array<std::string_view, 7> phrases = {"uncalib",      "not calib", "unscaled", "not scaled",
                                                       "unkalibriert", "adc count", "raw count"};
  constexpr std::array<std::string_view, 4> others = {"conj", "inverse", "normalized", "normalised"};
  const std::string plain = lower_case(remark);
  const NameWords words = words_of_name(remark);
  if (std::ranges::any_of(phrases, [&](std::string_view phrase) { return plain.find(phrase) != std::string::npos; })) return true;
  if (has_one_word(words, others) || factor_in_title(remark)) return true;
  return use_of_number(remark) == NumberUse::multiplies && states_other_number(remark) && !is_of_sensor(plain);
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
