#include "frf/mat/mat_polar.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr auto magnitude_words = std::to_array<std::string_view>(
    {"mag", "mags", "magnitude", "magnitudes", "abs", "amp", "ampl", "amplitude", "amplitudes", "modulus", "mod", "betrag"});
constexpr auto phase_words =
    std::to_array<std::string_view>({"phase", "phases", "phas", "pha", "phs", "ph", "ang", "angle", "angles", "arg"});
constexpr auto degree_words = std::to_array<std::string_view>({"deg", "degs", "degree", "degrees"});
constexpr auto radian_words = std::to_array<std::string_view>({"rad", "rads", "radian", "radians"});
constexpr std::size_t shortest_glued = 3;

using PolarTokens = std::vector<std::string>;

/// "H", "mag" of H_mag, HMag and H.Mag.
PolarTokens tokens_of(std::string_view name) {
  PolarTokens tokens(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool word = std::isalnum(c) != 0 || c >= 0x80;
    const bool begins = i > 0 && std::isupper(c) != 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if ((begins || !word) && !tokens.back().empty()) tokens.emplace_back();
    if (word) tokens.back() += name[i];
  }
  if (tokens.back().empty()) tokens.pop_back();
  return tokens;
}

template <std::size_t Size>
bool is_one_of(std::string_view word, const std::array<std::string_view, Size>& words) {
  return std::ranges::find(words, lower_case(word)) != words.end();
}

AngleUnit unit_word(std::string_view word) {
  if (is_one_of(word, degree_words)) return AngleUnit::degrees;
  return is_one_of(word, radian_words) ? AngleUnit::radians : AngleUnit::unstated;
}

/// "phasedeg" as "phase" and "deg".
void part_glued_unit(PolarTokens& tokens) {
  const std::string last = lower_case(tokens.back());
  for (const std::string_view unit : {"deg", "rad"}) {
    if (!last.ends_with(unit) || !is_one_of(std::string_view(last).substr(0, last.size() - unit.size()), phase_words)) continue;
    tokens.back().resize(last.size() - unit.size());
    tokens.emplace_back(unit);
    return;
  }
}

/// Takes the word for a part off: whole at the end or the beginning, else glued to a name, "frfmag", "absfrf".
std::optional<bool> take_part_word(PolarTokens& tokens) {
  for (const bool at_end : {true, false}) {
    const std::string word = at_end ? tokens.back() : tokens.front();
    const bool phase = is_one_of(word, phase_words);
    if (!phase && !is_one_of(word, magnitude_words)) continue;
    tokens.erase(at_end ? tokens.end() - 1 : tokens.begin());
    return phase;
  }
  for (const bool phase : {false, true}) {
    const auto take = [&](std::string_view word) {
      std::string &last = tokens.back(), &first = tokens.front();
      if (word.size() < shortest_glued) return false;
      if (last.size() > word.size() && lower_case(last).ends_with(word)) {
        last.resize(last.size() - word.size());
        return true;
      }
      if (first.size() > word.size() && lower_case(first).starts_with(word)) {
        first.erase(0, word.size());
        return true;
      }
      return false;
    };
    if (phase ? std::ranges::any_of(phase_words, take) : std::ranges::any_of(magnitude_words, take)) return phase;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PolarName> polar_name(std::string_view name) {
  PolarTokens tokens = tokens_of(name);
  if (tokens.empty()) return std::nullopt;
  part_glued_unit(tokens);
  PolarName out;
  for (std::size_t k = 1; k < tokens.size(); ++k) {
    const bool behind = k + 1 == tokens.size() || is_one_of(tokens[k - 1], phase_words);
    const AngleUnit unit = unit_word(tokens[k]);
    if (unit == AngleUnit::unstated || !behind) continue;
    out.unit = unit;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(k));
    if (k == tokens.size() && k > 1 && lower_case(tokens.back()) == "in") tokens.pop_back();
    break;
  }
  const auto phase = take_part_word(tokens);
  if (!phase || (!*phase && out.unit != AngleUnit::unstated)) return std::nullopt;
  out.phase = *phase;
  for (const std::string& token : tokens) out.base += (out.base.empty() ? "" : "_") + token;
  return out;
}

}  // namespace jointid::frf
