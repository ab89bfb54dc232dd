#pragma once

#include "frf/file/columns.hpp"

namespace jointid::frf {

/// The units that the names of columns without one end in (suffixed_name()). Of a column "x_in" beside one "x_out" none is taken.
void take_unit_suffixes(Columns& columns);

}  // namespace jointid::frf
