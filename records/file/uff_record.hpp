#pragma once

#include <filesystem>
#include <vector>

#include "records/file/record.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {

/// Reads the time responses (function type 1) of a universal file: DOF from record 6, kind and unit from record 9 (data type 8,
/// 11, 12 or 13, else its unit label; the label if it fits the kind, dataset 164 where there is none), rate and start from the
/// even abscissa, in s. Records with other functions are passed over. A record of a DOF that is there already begins the next
/// blow or run. Where channels are given, those of each run are read, in that order: by name (the DOF, the first identification
/// line of one without direction) or number in the run. Of those the DOF, the unit and the kind that the record does not state
/// are the given ones. Throws InputError for a channel that is no force or motion, or has no direction and is not given; for what
/// is given against what the record states; an uneven abscissa, complex values, and channels of one run that differ in rate or
/// length.
std::vector<Record> read_uff_records(const std::filesystem::path& path, const RecordOptions& options = {});

}  // namespace jointid::records
