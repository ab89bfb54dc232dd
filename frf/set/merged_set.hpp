#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Sets of one structure as one, on the lines of the first one. FRFs that none of them has are NaN. With more than one set the
/// noise is kept as variances if every set has its own (coherences by H1), else not at all. Covariances are kept if some set has
/// them; those between FRFs of different sets are zero. They are a factor unless some set has pairs; columns of sets with a
/// common reference are side by side. At least one set. Throws InputError (data) if a set has other lines (beyond
/// axis_tolerance), or if an FRF is in two sets.
FrfSet merged(std::vector<FrfSet> sets);

}  // namespace jointid::frf
