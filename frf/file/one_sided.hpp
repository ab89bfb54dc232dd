#pragma once

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Throws InputError where FRFs go from 0 to the sampling rate f_s, H(f_s − f) = H*(f), in the quantity of the file. Looks at twelve
/// lines of the first FRF, and only where the axis allows it; they are not counted.
void require_one_sided(FrfSource& source);

}  // namespace jointid::frf
