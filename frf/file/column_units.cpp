#include "frf/file/column_units.hpp"

#include <algorithm>

#include "frf/file/unit_suffix.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {

void take_unit_suffixes(Columns& columns) {
  const bool both =
      std::ranges::any_of(columns.columns, [](const NumberColumn& c) { return lower_case(c.name).ends_with("_out"); });
  for (NumberColumn& column : columns.columns) {
    if (!column.unit.empty() || (both && lower_case(column.name).ends_with("_in"))) continue;
    column.unit = suffixed_name(column.name).unit;
  }
}

}  // namespace jointid::frf
