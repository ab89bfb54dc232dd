#include "frf/set/unit_label.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "frf/text/label_text.hpp"

namespace jointid::frf {
namespace {

Unit power(const Unit& unit, int exponent) {
  return {std::pow(unit.si, exponent), unit.length * exponent, unit.time * exponent,
          unit.force * exponent,       unit.angle * exponent,  unit.amplitude};
}

/// Empty where one is of rms values and the other of peaks.
std::optional<Unit> product(const Unit& a, const Unit& b) {
  const bool stated = a.amplitude != Amplitude::unstated && b.amplitude != Amplitude::unstated;
  if (stated && a.amplitude != b.amplitude) return std::nullopt;
  return Unit{a.si * b.si,       a.length + b.length, a.time + b.time,
              a.force + b.force, a.angle + b.angle,   a.amplitude != Amplitude::unstated ? a.amplitude : b.amplitude};
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Recursive descent over the grammar of the header, in plain ASCII.
class LabelParser {
 public:
  explicit LabelParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> whole() {
    const auto unit = parse_product();
    skip_blanks();
    if (!unit || !rest_.empty()) return std::nullopt;
    if (!depends_on_case_.empty() && case_is_lost_) {
      unclear_ = depends_on_case_;
      return std::nullopt;
    }
    return unit;
  }

  const std::string& unknown() const { return unknown_; }               ///< the word that is no unit, or empty
  const std::vector<std::string>& unclear() const { return unclear_; }  ///< the units that a word may be
  bool mixes_amplitudes() const { return mixes_amplitudes_; }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_not_of(' '))); }

  bool take(char symbol) {
    skip_blanks();
    if (!rest_.starts_with(symbol)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view next_word() const {
    std::size_t end = 0;
    while (end < rest_.size() && (is_letter(rest_[end]) || (end > 0 && (rest_[end] == '\'' || rest_[end] == '_')))) ++end;
    return rest_.substr(0, end);
  }

  bool take_word(std::string_view wanted) {
    skip_blanks();
    const std::string_view word = next_word();
    if (lower_case(word) != wanted) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  /// The dot of an abbreviation, "in./sec.", is no product.
  void skip_full_stop() {
    if (!rest_.starts_with('.')) return;
    if (rest_.size() == 1 || (!is_letter(rest_[1]) && !is_digit(rest_[1]) && rest_[1] != '(')) rest_.remove_prefix(1);
  }

  /// Whether the next factor divides; empty where it is no factor.
  std::optional<bool> take_operator() {
    skip_full_stop();
    if (take('/') || take_word("per")) return true;
    if (take('*') || take('.')) return false;
    if (rest_.starts_with('-')) {
      if (rest_.size() < 2 || (!is_letter(rest_[1]) && rest_[1] != '(')) return std::nullopt;
      rest_.remove_prefix(1);
    }
    return false;
  }

  std::optional<Unit> parse_product() {
    auto unit = parse_power();
    while (unit) {
      skip_full_stop();
      skip_blanks();
      if (rest_.empty() || rest_[0] == ')') break;
      const auto divides = take_operator();
      const auto next = divides ? parse_power() : std::nullopt;
      if (!next) return std::nullopt;
      unit = product(*unit, power(*next, *divides ? -1 : 1));
      mixes_amplitudes_ = mixes_amplitudes_ || !unit;
    }
    return unit;
  }

  std::optional<Unit> parse_power() {
    const auto base = parse_atom();
    const auto exponent = base ? parse_exponent() : std::nullopt;
    return exponent ? std::optional(power(*base, *exponent)) : std::nullopt;
  }

  /// 1 where there is none; empty where it is wrong.
  std::optional<int> parse_exponent() {
    skip_full_stop();
    const std::string_view before = rest_;
    const bool caret = take('^');
    if (!caret) rest_ = before;
    const bool enclosed = caret && take('(');
    if (caret) skip_blanks();
    int exponent = 1;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (error == std::errc()) rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if ((caret && error != std::errc()) || exponent < -9 || exponent > 9 || (enclosed && !take(')'))) return std::nullopt;
    return error == std::errc() ? exponent : exponent_in_words();
  }

  int exponent_in_words() {
    const std::string_view before = rest_;
    if (!take('-')) rest_ = before;
    for (const std::string_view word : {"squared", "sq", "sqd"}) {
      if (take_word(word)) return 2;
    }
    if (take_word("cubed")) return 3;
    rest_ = before;
    return 1;
  }

  std::optional<Unit> parse_atom() {
    if (take('(')) {
      const auto unit = parse_product();
      return unit && take(')') ? unit : std::nullopt;
    }
    if (take('1')) return rest_.empty() || (!is_digit(rest_[0]) && rest_[0] != '.') ? std::optional(Unit{}) : std::nullopt;
    return parse_word();
  }

  std::optional<Unit> parse_word() {
    const std::string_view word = next_word();
    UnitWord found = find_unit(word);
    if (!found.unit) {
      unknown_ = word;
      unclear_ = std::move(found.otherwise);
      return std::nullopt;
    }
    case_is_lost_ = case_is_lost_ || found.all_capitals;
    if (!found.otherwise.empty()) {
      depends_on_case_ = std::move(found.otherwise);
      depends_on_case_.insert(depends_on_case_.begin(), std::string(word));
    }
    rest_.remove_prefix(word.size());
    return found.unit;
  }

  std::string_view rest_;
  std::string unknown_;
  std::vector<std::string> unclear_, depends_on_case_;
  bool case_is_lost_ = false, mixes_amplitudes_ = false;
};

[[noreturn]] void fail(std::string_view label, const std::string& kind, const std::string& examples) {
  const std::string hint = unit_hint(label);
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = {},
                    .problem = "'" + shown_label(label) + "' is no unit of " + kind + " that is known",
                    .remedy = (hint.empty() ? "" : hint + (hint.ends_with('?') ? " " : "; ")) + "write " + examples});
}

bool is_frequency(const Unit& unit) { return unit.length == 0 && unit.time == -1 && unit.force == 0; }

/// 2π · 1000 / 2π as 1000.
double without_rounding(double value) {
  const double whole = std::round(value);
  return std::abs(value - whole) < 1e-12 * value ? whole : value;
}

/// The label with `word` in place of what the parser did not know.
std::string replaced(std::string text, const std::string& unknown, const std::string& word) {
  const std::size_t at = text.find(unknown);
  return at == std::string::npos ? text : text.replace(at, unknown.size(), word);
}

/// "m/s?": a letter that another program could not write.
std::string with_lost_letter(const std::string& text) {
  for (const char* letter : {"^2", "u", "*"}) {
    const std::string tried = replaced(text, "?", letter);
    if (tried != text && LabelParser(tried).whole()) return tried;
  }
  return {};
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view label) {
  return states_no_unit(label) ? std::nullopt : LabelParser(plain_label(label)).whole();
}

bool states_no_unit(std::string_view label) {
  const std::string text = lower_case(without_padding(label));
  return text.empty() || text == "none";
}

std::optional<double> seconds_per(std::string_view label) {
  if (states_no_unit(label)) return std::nullopt;
  const auto unit = parse_unit(label);
  if (!unit || !unit->same_dimension({1.0, 0, 1, 0})) fail(label, "time", "s, ms, us, min or h");
  return unit->si;
}

std::optional<double> hertz_per(std::string_view label) {
  if (states_no_unit(label)) return std::nullopt;
  constexpr double per_minute = 1.0 / 60.0;
  const std::string text = lower_case(plain_label(label));
  if (text == "r/min" || text == "u/min" || text == "r.p.m." || text == "c.p.m.") return per_minute;
  if (text == "c/s") return 1.0;
  const auto unit = parse_unit(label);
  if (unit && is_frequency(*unit) && unit->angle == 1) return without_rounding(unit->si / (2.0 * std::numbers::pi));
  if (unit && is_frequency(*unit) && unit->angle == 0 && std::abs(unit->si - per_minute) < 1e-12) return per_minute;
  fail(label, "frequency", "Hz, kHz, rad/s, deg/s, rpm or cpm");
}

std::string unit_hint(std::string_view label) {
  const std::string text = plain_label(label);
  LabelParser parser(text);
  if (states_no_unit(label) || parser.whole()) return {};
  if (parser.mixes_amplitudes()) return "it mixes rms values and peaks";
  if (!parser.unclear().empty())
    return parser.unclear().back() == parser.unknown()
               ? "'" + parser.unknown() + "' is not '" + parser.unclear().front() + "': small and capital letters count"
               : parser.unclear().front() + " may be " + parser.unclear().front() + " or " + parser.unclear().back() +
                     " where case was lost";
  const std::string_view other = not_a_unit(parser.unknown());
  if (!other.empty()) return parser.unknown() + " is " + std::string(other);
  const std::string near = near_unit(parser.unknown());
  std::string tried = near.empty() ? std::string() : replaced(text, parser.unknown(), near);
  if (tried.empty() || !LabelParser(tried).whole()) tried = with_lost_letter(text);
  return tried.empty() ? std::string() : "did you mean '" + tried + "'?";
}

std::string shown_label(std::string_view label) {
  constexpr std::size_t longest = 64;
  const std::string text = utf8_label(without_padding(label));
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

}  // namespace jointid::frf
