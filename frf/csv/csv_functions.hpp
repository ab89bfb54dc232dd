#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frf/csv/csv_parts.hpp"

namespace jointid::frf {

/// "|H11|/(m/s2/N)", "arg(H11)/°", "H11 Re in g/N": a quantity over its unit (DIN 1313) or in it. Empty where what stands behind
/// the stroke is no unit of an FRF, of an angle or a level.
std::optional<CsvTitle> quantity_over_unit(std::string_view cell);

/// "|H11|", "arg(H11)", "∠H11", "Re{H11}", "ℑ(H11)" as "H11 mag", "H11 phase", "H11 re", "H11 im"; words for a part in other
/// languages as the part; any other title as it is. Brackets that hold a unit are none of a function, but where the unit is known.
std::string function_as_part(std::string_view title, bool unit_known);

/// "H_real", "H11.im", "H_phase_deg", "re_H11" as "H11 re" …; any other title, and a part beside a unit, as it is.
std::string joined_part(std::string_view title);

/// "H1/Re", "1Z; Amplitude" and "UZ Phase Angle" as "H1 Re", "1Z Amplitude" and "UZ Phase"; any other title as it is.
std::string part_behind_sign(std::string_view title);

/// Titles that only together say that they are parts, "H_r" and "H_i", "ReH11" and "ImH11", "HReal" and "HImag", as "H re" and
/// "H im" …; all others stay as they are.
void pair_parts(std::vector<std::string>& titles);

/// "mag∠phase", "polar", "re+j*im": what cells of complex numbers look like, in a title.
bool says_complex(std::string_view text);

/// What a label says that a column is where it is no motion over force: "dynamic stiffness", "a spectrum"; else empty.
std::string_view other_quantity(std::string_view label);

/// Of what a label is where it is no FRF itself, "the conjugate" of "conj(H11)" and "H11*", "the inverse" of "1/H11"; else empty.
std::string_view other_function(std::string_view label);

}  // namespace jointid::frf
