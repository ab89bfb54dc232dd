#pragma once

#include <filesystem>
#include <vector>

#include "records/file/record.hpp"

namespace jointid::records {

/// Reads the time responses (function type 1) of a universal file: DOF from record 6, kind and unit from record 9 (data type 8,
/// 11, 12 or 13, else its unit label; the label if it fits the kind, else dataset 164), rate from the even abscissa, in s.
/// Records with other functions are passed over. A record of a DOF that is there already begins the next blow or run. Throws
/// InputError for a channel that is no force or motion, an uneven abscissa, complex values, and channels of one run that differ
/// in rate or length.
std::vector<Record> read_uff_records(const std::filesystem::path& path);

}  // namespace jointid::records
