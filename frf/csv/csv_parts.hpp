#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// What a column holds of its pair of DOFs; a pair is complete with re and im, or with mag and a phase.
enum class CsvPart : std::size_t { re, im, mag, phase_deg, phase_rad, var_re, var_im, coherence };
inline constexpr std::array<std::string_view, 8> csv_part_names = {"re",        "im",     "mag",    "phase_deg",
                                                                   "phase_rad", "var_re", "var_im", "coherence"};

/// The part that a word names, in any case: "re", "Real", "Betrag"; empty for others, and for "phase", which needs a unit.
std::optional<CsvPart> csv_part(std::string_view word);

/// Whether it names one, "phase" included.
bool is_csv_part(std::string_view word);

/// Whether a unit is that of angles, in words of several languages: "deg", "°", "degrés"; "rad", "radianti". "Grad" may be gon.
bool is_degrees(std::string_view unit);
bool is_radians(std::string_view unit);

/// A cell of the row of titles: "Frequency [Hz]", "4:+Y/1:+Y re (g/N)". Brackets that hold a part are of the title: "FRF
/// (Magnitude)".
struct CsvTitle {
  std::string title;
  std::string unit;  ///< as it stands in brackets; else empty
};

}  // namespace jointid::frf
