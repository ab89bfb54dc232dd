#pragma once

#include <string>

#include "frf/mat/mat_variable.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// What stands beside the array `frf` of a file, in its struct, the structs around it and those inside of them, and its
/// attributes, and would be left out. Throws InputError naming
///   - a number, or a text of one, that others multiply the FRFs by ("scale", "gain", "sensitivity") and that is not 1, or add to
///   them ("offset") and that is not 0;
///   - a text that states another sign of time, exp(-iωt), or conjugates.
void require_nothing_unread(MatFile& file, const MatInfo& frf);

/// What else of positive numbers stands there, one or one of each response, reference or FRF, and may be a factor by its name, which
/// is not known to be of something else: a phrase for the header, "numbers beside the FRFs are not applied to them: amp is 2.5". Empty
/// where there are none, and of numbers that are 1. `axis` holds the frequencies by the user's word. Throws InputError where one of
/// each channel is likely a factor ("weights").
std::string numbers_not_applied(MatFile& file, const MatInfo& frf, const FrfHeader& header, const std::string& axis);

/// The same of FRFs without a unit: throws InputError naming a text that may be one under another name ("yunit"), in structs beside
/// them one of a motion or a force that is not in SI, or a text or an attribute that ends in the unit of an FRF ("Accelerance [g/N]").
void require_no_other_unit(MatFile& file, const MatInfo& frf);

}  // namespace jointid::frf
