#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "frf/uff/uff_text.hpp"
#include "frf/uff/uff_units.hpp"

namespace jointid::frf::uff {
namespace {

struct Symbol {
  std::string_view name;
  Unit unit;
};

constexpr double standard_gravity = 9.80665;  // m/s², exact by definition
constexpr double pound_force = 4.4482216152605;

constexpr std::array<Symbol, 24> symbols = {{{"m", {1.0, 1, 0, 0}},
                                             {"cm", {1e-2, 1, 0, 0}},
                                             {"mm", {1e-3, 1, 0, 0}},
                                             {"um", {1e-6, 1, 0, 0}},
                                             {"\xB5m", {1e-6, 1, 0, 0}},
                                             {"nm", {1e-9, 1, 0, 0}},
                                             {"in", {0.0254, 1, 0, 0}},
                                             {"ft", {0.3048, 1, 0, 0}},
                                             {"s", {1.0, 0, 1, 0}},
                                             {"ms", {1e-3, 0, 1, 0}},
                                             {"N", {1.0, 0, 0, 1}},
                                             {"mN", {1e-3, 0, 0, 1}},
                                             {"uN", {1e-6, 0, 0, 1}},
                                             {"\xB5N", {1e-6, 0, 0, 1}},
                                             {"kN", {1e3, 0, 0, 1}},
                                             {"MN", {1e6, 0, 0, 1}},
                                             {"lbf", {pound_force, 0, 0, 1}},
                                             {"kgf", {standard_gravity, 0, 0, 1}},
                                             {"g", {standard_gravity, 1, -2, 0}},
                                             {"rad", {1.0, 0, 0, 0}},
                                             {"mrad", {1e-3, 0, 0, 0}},
                                             {"deg", {std::numbers::pi / 180.0, 0, 0, 0}},
                                             {"Nm", {1.0, 1, 0, 1}},
                                             {"1", {}}}};

Unit power(const Unit& unit, int exponent) {
  return {std::pow(unit.si, exponent), unit.length * exponent, unit.time * exponent, unit.force * exponent};
}

Unit product(const Unit& a, const Unit& b) {
  return {a.si * b.si, a.length + b.length, a.time + b.time, a.force + b.force};
}

/// Recursive descent over a Latin-1 label: product := factor {('*' | '·' | '/' | nothing) factor}.
class LabelParser {
 public:
  explicit LabelParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> whole() {
    const auto unit = product_of_factors();
    return unit && rest_.empty() ? unit : std::nullopt;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && rest_[0] == ' ') rest_.remove_prefix(1);
  }

  bool take(std::string_view token) {
    skip_blanks();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  std::optional<Unit> product_of_factors() {
    auto unit = factor();
    while (unit) {
      skip_blanks();
      if (rest_.empty() || rest_[0] == ')') break;
      const bool divide = take("/");
      if (!divide && !take("*")) take("\xB7");
      const auto next = factor();
      unit = next ? std::optional(product(*unit, power(*next, divide ? -1 : 1))) : std::nullopt;
    }
    return unit;
  }

  std::optional<Unit> factor() {
    auto unit = take("(") ? parenthesis() : symbol();
    if (!unit) return unit;
    const auto exponent = power_suffix();
    return exponent ? std::optional(power(*unit, *exponent)) : std::nullopt;
  }

  std::optional<Unit> parenthesis() {
    const auto unit = product_of_factors();
    return unit && take(")") ? unit : std::nullopt;
  }

  std::optional<Unit> symbol() {
    std::size_t length = 0;
    const auto letter = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '\xB5';
    };
    while (length < rest_.size() && letter(rest_[length])) ++length;
    if (length == 0 && rest_.starts_with('1')) length = 1;
    const std::string_view name = rest_.substr(0, length);
    for (const Symbol& known : symbols) {
      if (known.name != name) continue;
      rest_.remove_prefix(length);
      return known.unit;
    }
    return std::nullopt;
  }

  /// 1 when there is no suffix; empty when a power sign has no number behind it.
  std::optional<int> power_suffix() {
    if (take("\xB2")) return 2;
    if (take("\xB3")) return 3;
    const bool sign_seen = rest_.starts_with("**") || rest_.starts_with('^');
    if (sign_seen) rest_.remove_prefix(rest_[0] == '^' ? 1 : 2);
    const bool negative = sign_seen && rest_.starts_with('-');
    if (negative) rest_.remove_prefix(1);
    if (rest_.empty() || rest_[0] < '1' || rest_[0] > '9') return sign_seen ? std::nullopt : std::optional(1);
    const int exponent = rest_[0] - '0';
    rest_.remove_prefix(1);
    return negative ? -exponent : exponent;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view label) {
  const std::string columns = one_byte_per_column(trim(label));
  return columns.empty() ? std::nullopt : LabelParser(columns).whole();
}

}  // namespace jointid::frf::uff
