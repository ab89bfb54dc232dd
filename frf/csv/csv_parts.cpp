#include "frf/csv/csv_parts.hpp"

#include <algorithm>
#include <utility>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using enum CsvPart;

/// Other words for parts, in lower case; `phase` needs a unit.
constexpr std::array<std::pair<std::string_view, CsvPart>, 11> words_of_parts = {{{"real", re},
                                                                                  {"imag", im},
                                                                                  {"imag.", im},
                                                                                  {"imaginary", im},
                                                                                  {"magnitude", mag},
                                                                                  {"abs", mag},
                                                                                  {"amplitude", mag},
                                                                                  {"realteil", re},
                                                                                  {"imaginärteil", im},
                                                                                  {"imagin\xE4rteil", im},
                                                                                  {"betrag", mag}}};

}  // namespace

std::optional<CsvPart> csv_part(std::string_view word) {
  const std::string plain = lower_case(word);
  const auto found = std::ranges::find(csv_part_names, plain);
  if (found != csv_part_names.end()) return static_cast<CsvPart>(found - csv_part_names.begin());
  const auto other = std::ranges::find(words_of_parts, plain, [](const auto& pair) { return pair.first; });
  return other != words_of_parts.end() ? std::optional(other->second) : std::nullopt;
}

bool is_csv_part(std::string_view word) { return csv_part(word) || lower_case(word) == "phase"; }

}  // namespace jointid::frf
