#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frf/text/complex_text.hpp"

namespace jointid::frf {

/// What the name of a variable says of magnitudes and phases that are stored apart.
struct PolarName {
  std::string base;                         ///< "H" of H_mag, absH, H_phase_deg; empty of "mag", "phase"
  bool phase = false;                       ///< else a magnitude
  AngleUnit unit = AngleUnit::unstated;     ///< of a phase
};

/// By a word at its beginning or end, with a unit behind it: mag, magnitude, abs, amp, amplitude, modulus, Betrag; phase, ang, angle,
/// arg, ph; deg, rad. Empty where it has none.
std::optional<PolarName> polar_name(std::string_view name);

}  // namespace jointid::frf
