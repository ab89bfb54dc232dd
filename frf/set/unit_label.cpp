#include "frf/set/unit_label.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace jointid::frf {
namespace {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

constexpr double standard_gravity = 9.80665;  // m/s², exact by definition
constexpr double pound_force = 4.4482216152605;

constexpr std::array<NamedUnit, 22> known_units = {{{"m", {1.0, 1, 0, 0}},
                                                    {"cm", {1e-2, 1, 0, 0}},
                                                    {"mm", {1e-3, 1, 0, 0}},
                                                    {"um", {1e-6, 1, 0, 0}},
                                                    {"nm", {1e-9, 1, 0, 0}},
                                                    {"in", {0.0254, 1, 0, 0}},
                                                    {"ft", {0.3048, 1, 0, 0}},
                                                    {"s", {1.0, 0, 1, 0}},
                                                    {"ms", {1e-3, 0, 1, 0}},
                                                    {"N", {1.0, 0, 0, 1}},
                                                    {"mN", {1e-3, 0, 0, 1}},
                                                    {"uN", {1e-6, 0, 0, 1}},
                                                    {"kN", {1e3, 0, 0, 1}},
                                                    {"MN", {1e6, 0, 0, 1}},
                                                    {"lbf", {pound_force, 0, 0, 1}},
                                                    {"kgf", {standard_gravity, 0, 0, 1}},
                                                    {"g", {standard_gravity, 1, -2, 0}},
                                                    {"kg", {1.0, -1, 2, 1}},
                                                    {"rad", {}},
                                                    {"mrad", {1e-3, 0, 0, 0}},
                                                    {"deg", {std::numbers::pi / 180.0, 0, 0, 0}},
                                                    {"Nm", {1.0, 1, 0, 1}}}};

Unit power(const Unit& unit, int exponent) {
  return {std::pow(unit.si, exponent), unit.length * exponent, unit.time * exponent, unit.force * exponent};
}

Unit product(const Unit& a, const Unit& b) { return {a.si * b.si, a.length + b.length, a.time + b.time, a.force + b.force}; }

/// Writes superscripts, dots, stars and the micro sign in ASCII.
std::string plain(std::string_view label) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> spellings = {
      {{"⁻", "^-"}, {"¹", "1"}, {"²", "^2"}, {"³", "^3"}, {"·", "*"}, {"⋅", "*"}, {"µ", "u"}, {"μ", "u"}, {"**", "^"}}};
  std::string text(label);
  for (const auto& [from, to] : spellings) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) text.replace(at, from.size(), to);
  }
  for (std::size_t at = text.find("^-^"); at != std::string::npos; at = text.find("^-^")) text.erase(at + 2, 1);
  return text;
}

/// Recursive descent over  product := power {['*' | '.' | '/'] power},  power := atom ['^'] [integer],
/// atom := '(' product ')' | '1' | name.  Blanks may stand around all but units and exponents.
class LabelParser {
 public:
  explicit LabelParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> whole() {
    const auto unit = parse_product();
    skip_blanks();
    return unit && rest_.empty() ? unit : std::nullopt;
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_not_of(' '))); }

  bool take(char symbol) {
    skip_blanks();
    if (!rest_.starts_with(symbol)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::optional<Unit> parse_product() {
    auto unit = parse_power();
    while (unit) {
      skip_blanks();
      if (rest_.empty() || rest_[0] == ')') break;
      const bool divide = take('/');
      if (!divide && !take('*')) take('.');
      const auto next = parse_power();
      unit = next ? std::optional(product(*unit, power(*next, divide ? -1 : 1))) : std::nullopt;
    }
    return unit;
  }

  std::optional<Unit> parse_power() {
    const auto base = parse_atom();
    if (!base) return base;
    const bool caret = rest_.starts_with('^');
    if (caret) rest_.remove_prefix(1);
    int exponent = 1;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (error == std::errc()) rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if ((caret && error != std::errc()) || exponent < -9 || exponent > 9) return std::nullopt;
    return power(*base, exponent);
  }

  std::optional<Unit> parse_atom() {
    if (take('(')) {
      const auto unit = parse_product();
      return unit && take(')') ? unit : std::nullopt;
    }
    if (take('1')) return Unit{};
    const auto letters = std::ranges::find_if(rest_, [](unsigned char c) { return std::isalpha(c) == 0; });
    const std::string_view word = rest_.substr(0, static_cast<std::size_t>(letters - rest_.begin()));
    const auto found = std::ranges::find(known_units, word, &NamedUnit::name);
    if (found == known_units.end()) return std::nullopt;
    rest_.remove_prefix(word.size());
    return found->unit;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view label) { return LabelParser(plain(label)).whole(); }

std::string unit_names() {
  std::string all;
  for (const NamedUnit& each : known_units) all += (all.empty() ? "" : " ") + std::string(each.name);
  return all;
}

}  // namespace jointid::frf
