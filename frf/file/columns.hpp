#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// A named list of real numbers of a file, e.g. a channel of a time history.
struct NumberColumn {
  std::string name;
  std::string unit;  ///< as its header says it, "mm" of "Position [mm]" or "Position (mm)"; else empty
  std::vector<double> values;
};

/// "Position [mm]" and "Position (mm)" into name and unit; no values.
NumberColumn titled_column(std::string_view title);

/// The columns of one file, in its order.
struct Columns {
  std::string file;
  std::vector<NumberColumn> columns;

  /// The column of that name, whatever its case, or of that number, from 1. Throws InputError (data) that lists the columns.
  const NumberColumn& column(std::string_view name_or_number) const;

  /// The first column with a word that is one of `words` (lower case) and none that is one of `without`, or null.
  const NumberColumn* find(const std::vector<std::string_view>& words, const std::vector<std::string_view>& without = {}) const;
};

/// Reads real columns of a file:
///   - text: lines of numbers, separated by semicolon, tab, comma or blanks (the first of these that stands in the first line);
///     with semicolons numbers may have decimal commas. A first line that is not all numbers names the columns, else their
///     names are 1, 2, … Lines that begin with # or % are comments. An empty cell is NaN;
///   - MATLAB v5 to v7.3 and HDF5 (datasets of the root): every real vector; of a real matrix NAME, whose longer axis counts the
///     samples, NAME(1), NAME(2), …
/// Throws InputError naming line and column of what is no number.
Columns read_columns(const std::filesystem::path& path);

}  // namespace jointid::frf
