#include "frf/file/unit_suffix.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

#include "frf/csv/csv_suffix.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

enum class NamedQuantity { unknown, axis, displacement, velocity, acceleration, force, moment, angle, time, frequency };

struct QuantityWords {
  NamedQuantity quantity;
  std::string_view words;
};

constexpr std::array quantity_words = std::to_array<QuantityWords>({
    {NamedQuantity::axis, " x y z ax ay az rx ry rz "},
    {NamedQuantity::displacement,
     " u disp displ displacement pos position coord weg verschiebung slip deflection deformation extension stroke gap amplitude "
     "amp delta "
     "lvdt travel elongation d s "},
    {NamedQuantity::velocity, " v vel velocity speed geschwindigkeit ldv laser "},
    {NamedQuantity::acceleration, " a acc accel acceleration accelerance accelerometer beschl beschleunigung inertance "},
    {NamedQuantity::force, " f force load kraft last hammer friction tangential normal preload fx fy fz "},
    {NamedQuantity::moment, " torque moment drehmoment mx my mz "},
    {NamedQuantity::angle, " angle rotation theta phi winkel "},
    {NamedQuantity::time, " t time zeit temps timestamp tiempo tempo tijd dt step interval period ts "},
    {NamedQuantity::frequency, " freq frequency frequenz fs rate omega w bandwidth band "},
});

/// "acc" of "acc1" in lower case.
std::string plain_word(std::string_view word) {
  while (!word.empty() && std::isdigit(static_cast<unsigned char>(word.back())) != 0) word.remove_suffix(1);
  return lower_case(word);
}

/// Of the first of some words that says it; an axis only where none says more.
NamedQuantity quantity_named_by(const std::vector<std::string_view>& words) {
  NamedQuantity found = NamedQuantity::unknown;
  for (const std::string_view word : words) {
    const std::string padded = " " + plain_word(word) + " ";
    const auto known = std::ranges::find_if(quantity_words, [&](const QuantityWords& each) {
      return padded.size() > 2 && each.words.find(padded) != std::string_view::npos;
    });
    if (known == quantity_words.end()) continue;
    if (known->quantity != NamedQuantity::axis) return known->quantity;
    found = NamedQuantity::axis;
  }
  return found;
}

bool is_motion(const Unit& unit) { return unit.force == 0 && (unit.length == 1 || unit.angle == 1) && unit.time <= 0; }

bool fits(NamedQuantity quantity, const Unit& unit) {
  const bool motion = is_motion(unit);
  switch (quantity) {
    case NamedQuantity::unknown:
      return true;
    case NamedQuantity::axis:
      return motion;
    case NamedQuantity::displacement:
      return motion && unit.time == 0;
    case NamedQuantity::velocity:
      return motion && unit.time == -1;
    case NamedQuantity::acceleration:
      return motion && unit.time == -2;
    case NamedQuantity::force:
      return unit.same_dimension({1.0, 0, 0, 1}) || unit.same_dimension({1.0, 1, 0, 1}) ||
             (unit.length == 0 && unit.force == 0 && unit.time == -1 && unit.angle == 1);  // f is a frequency, too
    case NamedQuantity::moment:
      return unit.same_dimension({1.0, 1, 0, 1});
    case NamedQuantity::angle:
      return unit.length == 0 && unit.force == 0 && unit.angle == 1;
    case NamedQuantity::time:
      return unit.same_dimension({1.0, 0, 1, 0});
    case NamedQuantity::frequency:
      return unit.length == 0 && unit.force == 0 && unit.time == -1;
  }
  return false;
}

/// Units that are nothing else behind an underscore, as they are written.
bool is_plain_unit(std::string_view word) {
  constexpr auto words = std::to_array<std::string_view>(
      {"N",   "kN",     "mN",      "daN", "MN",  "lbf", "LBF", "kgf", "kip", "mm",   "MM",   "um", "nm",
       "cm",  "micron", "microns", "Nm",  "kNm", "Nmm", "ms",  "us",  "sec", "msec", "usec", "Hz", "kHz",
       "deg", "rad",    "mrad",    "rpm", "V",   "mV",  "Pa",  "kPa", "MPa", "bar",  "µm",   "μm"});
  return std::ranges::find(words, word) != words.end();
}

/// What the last words of a name state behind the others, `before`; empty where they state nothing.
std::string unit_of_words(const std::vector<std::string_view>& words, NamedQuantity before) {
  const bool product = before == NamedQuantity::moment && words.size() == 2;
  const std::string label = words.size() == 1 ? std::string(words.front())
                            : product         ? std::string(words[0]) + "*" + std::string(words[1])
                                              : ratio_of_words(words);
  const auto unit = parse_unit(label);
  if (words.size() == 1) {
    constexpr std::string_view letters = "msgG";  // N is a plain one
    if (label.size() == 1 && !is_plain_unit(label) && letters.find(label) == std::string_view::npos) return {};
    if (!is_plain_unit(words.front()) && before == NamedQuantity::unknown) return {};
    if (!unit) return is_plain_unit(words.front()) && !not_a_unit(label).empty() ? label : std::string();
    return fits(before, *unit) ? label : std::string();
  }
  if (!unit || !fits(before, *unit)) return {};
  const bool ratio = is_motion(*unit) && unit->time < 0;
  return product || ratio || before != NamedQuantity::unknown ? label : std::string();
}

}  // namespace

SuffixedName suffixed_name(std::string_view name) {
  constexpr std::string_view between = "_ ";
  const std::size_t own = name.rfind('.') == std::string_view::npos ? 0 : name.rfind('.') + 1;
  std::vector<std::size_t> cuts;  // with something on both sides
  for (std::size_t at = name.find_first_of(between, own + 1); at != std::string_view::npos && at + 1 < name.size();
       at = name.find_first_of(between, at + 1))
    cuts.push_back(at);
  std::string plain(name);
  std::ranges::replace(plain, ' ', '_');
  constexpr std::size_t most_words = 4;
  if (cuts.size() > most_words) cuts.erase(cuts.begin(), cuts.end() - most_words);
  for (const std::size_t cut : cuts) {
    const std::string_view stem = name.substr(own, cut - own);
    std::string parted(stem);
    std::ranges::replace_if(
        parted, [](unsigned char c) { return c < 0x80 && std::isalnum(c) == 0; }, ' ');
    std::string label = unit_of_words(split(std::string_view(plain).substr(cut + 1), '_'), quantity_named_by(split(parted, ' ')));
    if (!label.empty()) return {name.substr(0, cut), std::move(label)};
  }
  return {name, {}};
}

std::string stiffness_or_mass_suffix(std::string_view name) {
  const std::vector<std::string_view> words = split(name, '_');
  for (std::size_t first = 1; first < words.size(); ++first) {
    std::string label = ratio_of_words({words.begin() + static_cast<std::ptrdiff_t>(first), words.end()});
    const auto unit = parse_unit(label);
    if (unit && (unit->same_dimension({1.0, -1, 0, 1}) || unit->same_dimension({1.0, -1, 2, 1}))) return label;
  }
  return {};
}

}  // namespace jointid::frf
