#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frf/text/unit_names.hpp"

/// Unit labels as files carry them: one table and one grammar for all readers.
///
/// A label may be UTF-8, Latin-1 or an old DOS code page, padded with blanks or NULs (what follows a NUL is padding), quoted, and
/// in any case.
///   product := power {[* · . - blank | / per] power}, from left to right: "m/s/s" is m/s², "m/s*s" is m
///   power   := atom [[^ | **] integer −9 … 9 | ² ³ ⁻² | squared | cubed]
///   atom    := 1 | unit | ( product ) | [ product ] | { product }
/// Units are those of frf/text/unit_names.cpp, e.g. g G gn g's, IN/S^2, mm/sec^2, in/s/s, LBF, lbs, kip, kgf, kp, daN, dyn, ozf,
/// mil, rad/sec, rpm, KHz, msec, µs, "Newton", "meters per second squared". g is standard gravity, lb is pound-force.
///
/// Case counts only between mN and MN, mHz and MHz, nm and Nm. They are taken as they are written, except where the label shows
/// that its case was lost: "mn", "NM" and "MM/MN" are not understood, and unit_hint() says why. Words of amplitudes (rms, pk,
/// pk-pk) are understood and kept beside the factor: a ratio rms/rms needs none. "g rms/N pk" is not understood. Volts, counts,
/// dB, EU, Pa, strain, % are never understood, nor are factors ("10 N", "1e-3 m").
namespace jointid::frf {

/// The unit of a label; empty when any of it is not understood, and for a label that states nothing.
std::optional<Unit> parse_unit(std::string_view label);

/// Whether the label states no unit: blank, NONE in any case, padding.
bool states_no_unit(std::string_view label);

/// Factor to s of the label of a time axis: 1e-3 for "ms", "msec" and "Milliseconds". Empty where the label states nothing.
/// Throws InputError (data; the caller adds file and place, see located()) that names any other label.
std::optional<double> seconds_per(std::string_view label);

/// Factor to Hz of the label of a frequency axis: Hz 1, kHz 1000, rad/s 1/2π, deg/s 1/360, rpm, cpm, rev/min and 1/min 1/60.
/// "1/s" may be Hz or rad/s and is refused. Empty where the label states nothing. Throws InputError (data) that names any other
/// label.
std::optional<double> hertz_per(std::string_view label);

/// What helps with a label that is not understood: "did you mean 'mm/s^2'?", "V is a voltage", "MN may be mN or MN where case was
/// lost"; empty when nothing is known of it, and when parse_unit() understands it.
std::string unit_hint(std::string_view label);

/// The label for messages: UTF-8 without its padding, cut after 64 bytes.
std::string shown_label(std::string_view label);

}  // namespace jointid::frf
