#pragma once

#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/hdf5/table_file.hpp"
#include "frf/mat/mat_variable.hpp"

namespace jointid::frf::hdf5 {

/// The functions of Hdf5Module, each in a source of its own.
bool has_format_attribute(const std::filesystem::path& path);
std::unique_ptr<FrfSource> open_source(const std::filesystem::path& path);
std::unique_ptr<LinesOutput> create_lines_file(const TemporaryFile& file, const FrfHeader& header,
                                               const Hdf5WriteOptions& options);
std::unique_ptr<TableInput> open_table(const std::filesystem::path& path);
std::unique_ptr<TableOutput> create_table(const TemporaryFile& file, const TableHeader& header, std::size_t rows);
std::unique_ptr<MatFile> open_mat_v73(const std::filesystem::path& path);

}  // namespace jointid::frf::hdf5
