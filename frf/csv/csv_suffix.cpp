#include "frf/csv/csv_suffix.hpp"

#include <algorithm>
#include <array>

#include "frf/set/units.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

template <std::size_t Size>
bool is_one_word(std::string_view word, const std::array<std::string_view, Size>& words) {
  return std::ranges::find(words, word) != words.end();
}

/// As they are written: in lower case N may be a number of something.
bool begins_ratio(std::string_view word) {
  constexpr auto motions =
      std::to_array<std::string_view>({"m", "mm", "um", "g", "G", "in", "ft", "cm", "nm", "mg", "rad", "deg", "inch"});
  return is_one_word(word, motions);
}

bool ends_ratio(std::string_view word) {
  constexpr auto forces =
      std::to_array<std::string_view>({"N", "kN", "mN", "daN", "MN", "lbf", "LBF", "lb", "kgf", "Nm", "newton"});
  return is_one_word(word, forces);
}

}  // namespace

std::string ratio_of_words(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool number = words[i].find_first_not_of("0123456789") == std::string_view::npos;
    if (lower_case(words[i]) == "per") continue;
    if (number && (i == 0 || words[i].size() != 1)) return {};
    if (i > 0 && !number) out += '/';
    out += words[i];
  }
  return out;
}

void take_ratio(CsvTitle& title) {
  constexpr std::size_t most_words = 6;
  if (!title.unit.empty() || title.title.find('_') == std::string::npos) return;
  const std::vector<std::string_view> words = split(title.title, '_');
  for (std::size_t first = 0; first + 1 < words.size(); ++first) {
    if (!begins_ratio(words[first])) continue;
    for (std::size_t last = first + 1; last < std::min(words.size(), first + most_words); ++last) {
      if (!ends_ratio(words[last])) continue;
      const std::string unit = ratio_of_words(
          {words.begin() + static_cast<std::ptrdiff_t>(first), words.begin() + static_cast<std::ptrdiff_t>(last) + 1});
      if (!quantity_of_unit(unit)) continue;
      std::string rest;
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (i < first || i > last) rest += (rest.empty() ? "" : "_") + std::string(words[i]);
      }
      title = {std::move(rest), unit};
      return;
    }
  }
}

}  // namespace jointid::frf
