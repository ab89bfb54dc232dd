#pragma once

#include <filesystem>
#include <vector>

#include "records/file/record.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {

/// Reads the time records of a file, in memory, by its content: .npy (read_npy()), UFF 58 (read_uff_records()), or columns of
/// text, MATLAB (fields of structs too) and HDF5 (frf::read_columns()). Sample numbers of one file are one record, but a UFF file
/// has a record more whenever a DOF comes again. A column of times must be even to 1 % of a step; its unit is the one that its
/// title states (seconds_per_number()), else s. A rate that it gives is taken as the number of six digits next to it where that
/// is nearer than 1e-6. Throws InputError: no times and no rate, a rate that is 1e-3 or more off the one that the file states, a
/// channel that is not there, a column that two channels want, a unit that is no force or motion or that the file contradicts
/// (contradiction()), files of more than 2 GiB (most_file_bytes, most_numbers) and what the readers of the formats say.
std::vector<Record> read_records(const std::filesystem::path& path, const RecordOptions& options);

}  // namespace jointid::records
