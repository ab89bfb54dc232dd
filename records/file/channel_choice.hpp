#pragma once

#include <string>
#include <vector>

#include "frf/file/columns.hpp"

namespace jointid::records {

/// Places of the columns that are asked for, by name or number; of all but a column of times (find_times()) where none is. Throws
/// InputError for one that is not there, one that is named twice, and where none is left.
std::vector<std::size_t> chosen_columns(const frf::Columns& columns, const std::vector<std::string>& wanted);

/// The name of the column of times, or empty.
std::string time_column(const frf::Columns& columns);

}  // namespace jointid::records
