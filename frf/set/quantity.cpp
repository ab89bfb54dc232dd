#include "frf/set/quantity.hpp"

#include <array>
#include <cctype>
#include <limits>
#include <utility>

#include "base/complex.hpp"
#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<const char*, 3> quantity_names = {"receptance", "mobility", "accelerance"};
constexpr std::array<const char*, 3> units = {"m/N", "m/(s*N)", "m/(s^2*N)"};

/// The field's words for motion over force.
constexpr std::array<std::pair<std::string_view, Quantity>, 9> quantity_words = {{
    {"receptance", Quantity::receptance},
    {"dynamic compliance", Quantity::receptance},
    {"dynamic flexibility", Quantity::receptance},
    {"displacement/force", Quantity::receptance},
    {"mobility", Quantity::mobility},
    {"velocity/force", Quantity::mobility},
    {"accelerance", Quantity::accelerance},
    {"inertance", Quantity::accelerance},
    {"acceleration/force", Quantity::accelerance},
}};

struct OtherWord {
  std::string_view word, problem, remedy;
};

constexpr std::string_view ask =
    "write receptance for displacement over force, mobility for velocity over force or accelerance for acceleration over force";
constexpr std::string_view invert =
    "export motion over force; an FRF cannot be inverted on its own, only the whole matrix can";

/// Words that leave it open what is meant, and those of force over motion.
constexpr std::array<OtherWord, 11> words_left_open = {{
    {"admittance", "may mean receptances, mobilities or accelerances", ask},
    {"compliance", "may mean static flexibilities or receptances", ask},
    {"flexibility", "may mean static flexibilities or receptances", ask},
    {"impedance", "is force over velocity, the inverse of a matrix of mobilities", invert},
    {"mechanical impedance", "is force over velocity, the inverse of a matrix of mobilities", invert},
    {"dynamic stiffness", "is force over displacement, the inverse of a matrix of receptances", invert},
    {"stiffness", "is force over displacement, the inverse of a matrix of receptances", invert},
    {"apparent mass", "is force over acceleration, the inverse of a matrix of accelerances", invert},
    {"dynamic mass", "is force over acceleration, the inverse of a matrix of accelerances", invert},
    {"effective mass", "is force over acceleration, the inverse of a matrix of accelerances", invert},
    {"transmissibility", "is motion over motion without a force", "export motion over force"},
}};

/// In lower case, with one blank for blanks, hyphens and underscores.
std::string plain_word(std::string_view text) {
  std::string word;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '-' || c == '_' || c == '\t';
    if (!blank) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty() && word.back() != ' ') {
      word += ' ';
    }
  }
  while (!word.empty() && word.back() == ' ') word.pop_back();
  return word;
}

}  // namespace

std::string name(Quantity quantity) { return quantity_names[static_cast<std::size_t>(quantity)]; }
std::string unit(Quantity quantity) { return units[static_cast<std::size_t>(quantity)]; }

std::string taken_for(Quantity given, Quantity stated) {
  return "taken for " + name(given) + ", not for the " + name(stated) + " that the file states";
}

Quantity parse_quantity(std::string_view text) {
  const std::string word = plain_word(text);
  for (const auto& [synonym, quantity] : quantity_words) {
    if (word == synonym) return quantity;
  }
  for (const auto& [other, problem, remedy] : words_left_open) {
    if (word != other) continue;
    throw InputError({.kind = ErrorKind::data,
                      .file = {},
                      .place = {},
                      .problem = "unknown FRF quantity '" + std::string(text) + "': it " + std::string(problem),
                      .remedy = std::string(remedy)});
  }
  const std::string near = nearest_word(word, quantity_names);
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = {},
                    .problem = "unknown FRF quantity '" + std::string(text) + "'",
                    .remedy = near.empty() ? "write receptance, mobility or accelerance"
                                           : "did you mean " + near + "?"});
}

Quantity parse_quantity(std::string_view text, std::optional<Quantity> given) {
  try {
    return parse_quantity(text);
  } catch (const InputError&) {
    if (given) return *given;
    throw;
  }
}

std::complex<double> from_receptance(Quantity quantity, double frequency_hz) {
  const double omega = angular(frequency_hz);
  switch (quantity) {
    case Quantity::mobility:
      return {0.0, omega};
    case Quantity::accelerance:
      return {-omega * omega, 0.0};
    case Quantity::receptance:
      break;
  }
  return {1.0, 0.0};
}

std::complex<double> to_receptance(Quantity quantity, double frequency_hz) {
  if (quantity != Quantity::receptance && frequency_hz == 0.0) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  return 1.0 / from_receptance(quantity, frequency_hz);
}

}  // namespace jointid::frf
