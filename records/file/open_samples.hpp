#pragma once

#include <filesystem>
#include <memory>

#include "records/file/sample_stream.hpp"

namespace jointid::records {

/// Opens a file by its content:
///   - columns of text (as frf::read_columns()), a line after another; the parts are of bytes;
///   - UFF 58 time data in SI units (uff_runs()), runs after each other; binary channels are read a block at a time, those of
///   text
///     go through a temporary file, one in memory after another;
///   - HDF5 and MATLAB v7.3, a block at a time;
///   - MATLAB v5 to v7 and .npy, which are held in memory (2 GiB at most).
/// Channels of a file that differ in length are cut to the shortest. Throws InputError.
std::unique_ptr<SampleStream> open_samples(const std::filesystem::path& path, const StreamOptions& options = {});

}  // namespace jointid::records
