#pragma once

#include <string>

#include "frf/file/columns.hpp"

namespace jointid::records {

/// Whether a column holds times by its title: a word time, t, zeit, temps, tiempo, tempo or timestamp and none that is rate, or
/// nothing but a unit of time ("sec", "ms"); not where a unit of something else is stated.
bool is_time_column(const frf::NumberColumn& column);

/// The first of them that is no single number, or null.
const frf::NumberColumn* find_times(const frf::Columns& columns);

/// The unit of times that a column states: its unit ("time (ms)", a row of units, an attribute), else the word behind the one of
/// time ("Time_ms", "t/us", "time in ms", "timeMs"); empty: none.
std::string stated_time_unit(const frf::NumberColumn& column);

/// Seconds per number of a column of times, 1 where it states no unit. Throws InputError (data) for a unit that is not understood
/// or no unit of time, samples and counts included.
double seconds_per_number(const frf::NumberColumn& column, const std::string& file);

}  // namespace jointid::records
