#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// What a label says of the amplitudes that it scales: "g rms", "mm/s pk", "mil pk-pk".
enum class Amplitude : std::uint8_t { unstated, peak, peak_to_peak, rms };

/// A unit as a factor to SI and exponents of length, time and force. Angles are pure numbers; that they are there is kept beside.
struct Unit {
  double si = 1.0;
  int length = 0;
  int time = 0;
  int force = 0;
  int angle = 0;  ///< exponent of rad, deg, cycle, revolution; 1 for Hz and rpm, too (2π rad/s, 2π/60 rad/s)
  Amplitude amplitude = Amplitude::unstated;  ///< not part of `si`

  bool same_dimension(const Unit& other) const { return length == other.length && time == other.time && force == other.force; }
};

/// What one word of a unit label is: symbols and words in any case ("N", "KHz", "newtons"). A word as the table writes it comes
/// first; otherwise case is ignored, where all that then fit are the same unit.
struct UnitWord {
  std::optional<Unit> unit;
  bool all_capitals = false;           ///< found only because case was ignored, and written in capitals alone, e.g. "MM"
  std::vector<std::string> otherwise;  ///< other units of these letters: for "MN" and "mn" also "mN"
};
UnitWord find_unit(std::string_view word);

/// What a word is that is no unit of an FRF ("a voltage", "a pressure"), or empty.
std::string_view not_a_unit(std::string_view word);

/// The known word that is nearest to `word`, a letter or two of a longer one off; empty if there is none, and for short words.
std::string near_unit(std::string_view word);

/// "m mm in … N kN lbf …", for messages.
std::string unit_names();

/// In lower case; bytes beyond ASCII stay.
std::string lower_case(std::string_view text);

}  // namespace jointid::frf
