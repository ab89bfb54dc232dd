#include "frf/set/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

/// A factor to SI units and the exponents of length, time and force.
struct Unit {
  double factor = 1.0;
  int length = 0;
  int time = 0;
  int force = 0;
};

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

constexpr std::array<NamedUnit, 13> known_units = {{
    {"m", {1.0, 1, 0, 0}},
    {"mm", {1e-3, 1, 0, 0}},
    {"um", {1e-6, 1, 0, 0}},
    {"in", {0.0254, 1, 0, 0}},
    {"ft", {0.3048, 1, 0, 0}},
    {"s", {1.0, 0, 1, 0}},
    {"N", {1.0, 0, 0, 1}},
    {"kN", {1e3, 0, 0, 1}},
    {"mN", {1e-3, 0, 0, 1}},
    {"lbf", {4.4482216152605, 0, 0, 1}},
    {"g", {9.80665, 1, -2, 0}},
    {"kg", {1.0, -1, 2, 1}},
    {"rad", {}},
}};

Unit power(const Unit& unit, int exponent) {
  return {std::pow(unit.factor, exponent), unit.length * exponent, unit.time * exponent,
          unit.force * exponent};
}

Unit product(const Unit& a, const Unit& b) {
  return {a.factor * b.factor, a.length + b.length, a.time + b.time, a.force + b.force};
}

/// Writes superscripts, dots and the micro sign in ASCII.
std::string plain(std::string_view label) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> spellings = {
      {{"⁻", "^-"}, {"¹", "1"}, {"²", "^2"}, {"³", "^3"}, {"·", "*"}, {"⋅", "*"}, {"µ", "u"}, {"μ", "u"}}};
  std::string text(label);
  for (const auto& [from, to] : spellings) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
      text.replace(at, from.size(), to);
    }
  }
  for (std::size_t at = text.find("^-^"); at != std::string::npos; at = text.find("^-^"))
    text.erase(at + 2, 1);
  return text;
}

/// Recursive descent over  product := power (('*' | '.' | '/') power)*,  power := atom ['^'] [integer],
/// atom := '(' product ')' | '1' | name.  Blanks may stand around all but units and exponents;
/// `ok_` turns false at the first thing that does not fit.
class LabelParser {
 public:
  explicit LabelParser(std::string_view text) : rest_(text) {}

  bool parse(Unit& unit) {
    unit = parse_product();
    skip_blanks();
    return ok_ && rest_.empty();
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_not_of(' '))); }

  bool take(char symbol) {
    skip_blanks();
    if (rest_.empty() || rest_[0] != symbol) return false;
    rest_.remove_prefix(1);
    return true;
  }

  Unit parse_product() {
    Unit unit = parse_power();
    while (ok_) {
      if (take('*') || take('.')) {
        unit = product(unit, parse_power());
      } else if (take('/')) {
        unit = product(unit, power(parse_power(), -1));
      } else {
        break;
      }
    }
    return unit;
  }

  Unit parse_power() {
    const Unit base = parse_atom();
    const bool caret = take('^');
    int exponent = 1;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (error == std::errc()) rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if ((caret && error != std::errc()) || std::abs(exponent) > 9) ok_ = false;
    return ok_ && error == std::errc() ? power(base, exponent) : base;
  }

  Unit parse_atom() {
    if (take('(')) {
      const Unit unit = parse_product();
      ok_ = ok_ && take(')');
      return unit;
    }
    if (take('1')) return {};
    const auto letters =
        std::find_if(rest_.begin(), rest_.end(), [](unsigned char c) { return std::isalpha(c) == 0; });
    const std::string_view word = rest_.substr(0, static_cast<std::size_t>(letters - rest_.begin()));
    const auto found = std::find_if(known_units.begin(), known_units.end(),
                                    [&](const NamedUnit& known) { return known.name == word; });
    ok_ = ok_ && found != known_units.end();
    if (!ok_) return {};
    rest_.remove_prefix(word.size());
    return found->unit;
  }

  std::string_view rest_;
  bool ok_ = true;
};

/// Motion per force: a length or an angle, over a force or a moment, over seconds to the quantity's power.
bool fits(const Unit& unit, Quantity quantity) {
  return unit.force == -1 && unit.time == -static_cast<int>(quantity) && std::abs(unit.length) <= 1;
}

[[noreturn]] void fail(std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = {},
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace

double si_factor(std::string_view unit_label, Quantity quantity) {
  constexpr std::size_t longest = 64;
  const std::string shown(unit_label.substr(0, longest));
  const std::string remedy =
      "write " + unit(quantity) + ", or another product of m mm um in ft s N kN mN lbf g kg rad";
  Unit unit;
  if (unit_label.size() > longest || !LabelParser(plain(unit_label)).parse(unit)) {
    fail("unknown unit '" + shown + "'", remedy);
  }
  if (!fits(unit, quantity)) fail("unit '" + shown + "' is not a unit of " + name(quantity), remedy);
  return unit.factor;
}

double si_factor(std::string_view unit_label, const FrfHeader& header) {
  const double factor = si_factor(unit_label, header.quantity);
  const auto rotates = [](const Dof& dof) { return dof.is_rotation(); };
  if (factor != 1.0 && (std::any_of(header.response.begin(), header.response.end(), rotates) ||
                        std::any_of(header.reference.begin(), header.reference.end(), rotates))) {
    fail("unit '" + std::string(unit_label) + "' does not tell how rotations are scaled",
         "store sets with rotations in SI units, " + unit(header.quantity));
  }
  return factor;
}

}  // namespace jointid::frf
