#pragma once

#include "frf/file/columns.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {

/// Samples per second of a table: by its column of times (stated_or_given_rate()), by RecordOptions::rate_hz, else by a number beside the
/// columns that is named as a rate (Fs, sample_rate …) in Hz or a step (dt, sample_interval …) in s, or in its own unit. Throws InputError
/// where nothing states it, where two statements differ, and where channels stand behind different columns of times.
double rate_of_table(const frf::Columns& table, const RecordOptions& options);

}  // namespace jointid::records
