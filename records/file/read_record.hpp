#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/file/record.hpp"

namespace jointid::records {

/// What the user says of a channel: its column, where it stood, and what its numbers are: SI = factor · (unit in SI) · number.
struct GivenChannel {
  std::string column;  ///< name, or number from 1
  frf::Dof dof;
  double factor = 1.0;
  std::string unit;
};

/// Parses "3=4:+Z g", "F=1:+Z N", "volts=1:+Z 44.5 N" (DOF, factor if any, unit). Throws InputError (usage).
GivenChannel parse_channel(const std::string& text);

/// What the user knows of a file and the file does not say.
struct RecordOptions {
  std::vector<GivenChannel> channels;  ///< those to read, in this order; needed by all files but UFF, where it names none
  std::string time;  ///< column of the times, s; default: the first whose name has the word time or t, or none of a rate
  std::optional<double> rate_hz;  ///< counts before any column of times
};

/// Reads the time records of a file, in memory, by its content: .npy (read_npy()), UFF 58 (read_uff_records()), or columns of
/// text, MATLAB (fields of structs too) and HDF5 (frf::read_columns()). Sample numbers of one file are one record, but a UFF file
/// has a record more whenever a DOF comes again. A column of times must be even to 1 % of a step; a rate that it gives is taken
/// as the number of six digits next to it where that is nearer than 1e-6. Throws InputError: no times and no rate, a channel that
/// is not there, a unit that is no force or motion, files of more than 2 GiB (most_file_bytes, most_numbers) and what the readers
/// of the formats say.
std::vector<Record> read_records(const std::filesystem::path& path, const RecordOptions& options);

}  // namespace jointid::records
