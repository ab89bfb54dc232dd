#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "base/temporary_file.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

class MatFile;
struct Hdf5WriteOptions;
struct TableHeader;

/// What an Hdf5Writer does until its file gets its name; finish() closes it.
class LinesOutput {
 public:
  virtual ~LinesOutput() = default;
  virtual std::size_t lines_per_chunk() const = 0;
  virtual void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values,
                           std::span<const Complex> variance, std::span<const double> coherence,
                           const CovarianceLines& covariance) = 0;
  virtual void finish() = 0;
};

/// The same of a TableWriter.
class TableOutput {
 public:
  virtual ~TableOutput() = default;
  virtual void append(std::span<const double> rows) = 0;
  virtual void finish() = 0;
};

/// What a TableReader does.
class TableInput {
 public:
  virtual ~TableInput() = default;
  virtual const TableHeader& header() const = 0;
  virtual std::size_t rows() const = 0;
  virtual void read(std::size_t column, std::size_t first, std::span<double> out) const = 0;
};

/// What the module hdf5 implements (base/module.hpp): all for which the HDF5 library is called. Files are written where a
/// temporary file stands, which must outlive what writes them.
class Hdf5Module {
 public:
  virtual ~Hdf5Module() = default;
  virtual bool has_format_attribute(const std::filesystem::path& path) = 0;
  virtual std::unique_ptr<FrfSource> open(const std::filesystem::path& path) = 0;
  virtual std::unique_ptr<LinesOutput> create(const TemporaryFile& file, const FrfHeader& header,
                                              const Hdf5WriteOptions& options) = 0;
  virtual std::unique_ptr<TableInput> open_table(const std::filesystem::path& path) = 0;
  virtual std::unique_ptr<TableOutput> create_table(const TemporaryFile& file, const TableHeader& header, std::size_t rows) = 0;
  virtual std::unique_ptr<MatFile> open_mat_v73(const std::filesystem::path& path) = 0;
};

/// Loads it; throws InputError where it is missing.
Hdf5Module& hdf5_module();

/// Whether it is there.
bool has_hdf5();

}  // namespace jointid::frf
