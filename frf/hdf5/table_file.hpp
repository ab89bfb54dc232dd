#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/temporary_file.hpp"
#include "frf/hdf5/hdf5_module.hpp"

namespace jointid::frf {

struct TableColumn {
  std::string name;
  std::string unit;
  double truth = 0.0;  ///< NaN when there is none
};

/// Content of a table, HDF5 layout `jointid-table` version 2. Root attributes: `format`, `version`, `checksum` and the texts.
/// Datasets: `column` [C] and `unit` [C] UTF-8, `truth` [C] float64, `rows` [N,C] float64, chunked by columns, `column_checksum`
/// [C] uint64. Version 1 has no checksums and is read, too.
struct TableHeader {
  std::map<std::string, std::string> texts;  ///< root attributes
  std::vector<TableColumn> columns;          ///< at least one
};

/// Writes a table row by row in order. The file appears with finish(), complete. Equal tables give equal
/// bytes.
class TableWriter {
 public:
  /// Throws InputError when the folder does not take the file.
  TableWriter(const std::filesystem::path& path, const TableHeader& header, std::size_t rows);

  /// Appends rows, [count, C] numbers. Throws InputError when the disk does not take them.
  void append(std::span<const double> rows);
  void finish();

 private:
  TemporaryFile temporary_;
  std::unique_ptr<TableOutput> file_;
};

/// Reads a table column by column.
class TableReader {
 public:
  /// Throws InputError when the file is no such table, or its header does not agree with its checksum.
  explicit TableReader(const std::filesystem::path& path);

  const TableHeader& header() const;
  std::size_t rows() const;
  /// Rows [first, first + out.size()) of a column. Throws InputError when the column does not agree with its checksum.
  void read(std::size_t column, std::size_t first, std::span<double> out) const;

 private:
  std::unique_ptr<TableInput> file_;
};

}  // namespace jointid::frf
