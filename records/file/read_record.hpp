#pragma once

#include <filesystem>
#include <vector>

#include "records/file/record.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {

/// Reads the time records of a file into memory, by its content: .npy (read_npy()), UFF 58 (read_uff_records()), or columns of
/// text, MATLAB (fields of structs too) and HDF5 (frf::read_columns()). One file is one record; a UFF file has a further record
/// each time a DOF is repeated. A column of times must be even to 1 % of a step; its unit is that of its title
/// (seconds_per_number()), else s. Its rate is rounded to six digits if that changes it by less than 1e-6. Throws InputError for
/// no times and no rate, a rate that differs by 1e-3 or more from the file's, a missing channel, or a column of two channels.
/// Also for a unit that is no force or motion or contradicts the file (contradiction()), for files of more than 2 GiB
/// (most_file_bytes, most_numbers), and as the readers of the formats.
std::vector<Record> read_records(const std::filesystem::path& path, const RecordOptions& options);

}  // namespace jointid::records
