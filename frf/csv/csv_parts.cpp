#include "frf/csv/csv_parts.hpp"

#include <algorithm>
#include <utility>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using enum CsvPart;

/// Other words for parts, in lower case; `phase` needs a unit.
constexpr std::array words_of_parts = std::to_array<std::pair<std::string_view, CsvPart>>({{"real", re},
                                                                                           {"re.", re},
                                                                                           {"realteil", re},
                                                                                           {"reell", re},
                                                                                           {"réel", re},
                                                                                           {"reale", re},
                                                                                           {"real-part", re},
                                                                                           {"imag", im},
                                                                                           {"imag.", im},
                                                                                           {"im.", im},
                                                                                           {"imaginary", im},
                                                                                           {"imaginärteil", im},
                                                                                           {"imagin\xE4rteil", im},
                                                                                           {"imaginär", im},
                                                                                           {"imaginaire", im},
                                                                                           {"immaginario", im},
                                                                                           {"imag-part", im},
                                                                                           {"reëel", re},
                                                                                           {"imaginair", im},
                                                                                           {"gerçek", re},
                                                                                           {"sanal", im},
                                                                                           {"实部", re},
                                                                                           {"実部", re},
                                                                                           {"虚部", im},
                                                                                           {"magnitud", mag},
                                                                                           {"振幅", mag},
                                                                                           {"幅值", mag},
                                                                                           {"幅度", mag},
                                                                                           {"magnitude", mag},
                                                                                           {"mag.", mag},
                                                                                           {"linmag", mag},
                                                                                           {"abs", mag},
                                                                                           {"amplitude", mag},
                                                                                           {"ampl", mag},
                                                                                           {"ampl.", mag},
                                                                                           {"amp", mag},
                                                                                           {"ampiezza", mag},
                                                                                           {"amplitud", mag},
                                                                                           {"betrag", mag},
                                                                                           {"coh", coherence},
                                                                                           {"coh.", coherence},
                                                                                           {"gamma2", coherence},
                                                                                           {"gamma^2", coherence},
                                                                                           {"γ²", coherence},
                                                                                           {"γ2", coherence},
                                                                                           {"γ^2", coherence},
                                                                                           {"kohärenz", coherence},
                                                                                           {"koh\xE4renz", coherence},
                                                                                           {"cohérence", coherence},
                                                                                           {"coherencia", coherence},
                                                                                           {"coerenza", coherence}});

constexpr std::array<std::string_view, 17> degrees = {"º",      "°",         "deg",    "deg.",  "degree", "degrees",
                                                      "degrés", "degr\xE9s", "degres", "gradi", "grados", "graus",
                                                      "graden", "grader",    "stopni", "度",    "stupně"};
constexpr std::array<std::string_view, 8> radians = {"rad",      "rads",    "radian",    "radians",
                                                     "radianti", "radiani", "radiantes", "bogenmaß"};

}  // namespace

std::optional<CsvPart> csv_part(std::string_view word) {
  const std::string plain = lower_case(word);
  const auto found = std::ranges::find(csv_part_names, plain);
  if (found != csv_part_names.end()) return static_cast<CsvPart>(found - csv_part_names.begin());
  const auto other = std::ranges::find(words_of_parts, plain, [](const auto& pair) { return pair.first; });
  return other != words_of_parts.end() ? std::optional(other->second) : std::nullopt;
}

bool is_degrees(std::string_view unit) { return std::ranges::find(degrees, lower_case(unit)) != degrees.end(); }

bool is_radians(std::string_view unit) { return std::ranges::find(radians, lower_case(unit)) != radians.end(); }

bool is_csv_part(std::string_view word) { return csv_part(word) || lower_case(word) == "phase"; }

}  // namespace jointid::frf
