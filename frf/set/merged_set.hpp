#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Sets of one structure as one, on the first one's lines: FRFs that none of them has are NaN. With more than one set the noise is kept
/// as variances where every set knows its own (coherences by H1), else not at all; covariances where some set has them, those between
/// FRFs of different sets zero: as a factor unless some set has pairs, the columns of sets with a reference in common side by side.
/// Throws InputError (data) when a set has other lines
/// (beyond axis_tolerance), or an FRF stands in two sets. At least one set.
FrfSet merged(std::vector<FrfSet> sets);

}  // namespace jointid::frf
