#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// A named list of real numbers of a file, e.g. a channel of a time history.
struct NumberColumn {
  std::string name;
  std::string unit;  ///< from its header, "mm" of "Position [mm]", "Position (mm)" and "pos_mm"; else empty
  std::vector<double> values;
};

/// "Position [mm]" and "Position (mm)" into name and unit; "u/mm" and "u in mm" have the unit mm and keep their name; no values.
NumberColumn titled_column(std::string_view title);

/// A comment or a free line above a table.
struct TableRemark {
  std::string place, text;
};

/// The columns of one file, in its order.
struct Columns {
  std::string file;
  std::vector<NumberColumn> columns;
  std::vector<TableRemark> remarks{};      ///< of a text, the first hundred
  std::vector<NumberColumn> attributes{};  ///< single numbers that are attributes in HDF5, "F@fs"

  /// Index of the column with that name (exact, else in any case, else "u" of "u/mm" and "u_mm"), or with that number, from 1.
  /// Throws InputError (data), with the list of columns, if there is none, and for a name of several columns.
  std::size_t place(std::string_view name_or_number) const;
  const NumberColumn& column(std::string_view name_or_number) const { return columns[place(name_or_number)]; }

  /// "a, b, c" for messages, the first twenty of many.
  std::string names() const;

  /// The first column with a word that is one of `words` (lower case) and none that is one of `without`, or null.
  const NumberColumn* find(const std::vector<std::string_view>& words, const std::vector<std::string_view>& without = {}) const;
};

/// Reads real columns of a file:
///   - text: lines of numbers below titles (ColumnTitles), separated by semicolon, tab, comma or blanks; with semicolons or tabs
///     numbers may have decimal commas (DecimalMark). Lines that begin with # or % are comments. An empty cell is NaN;
///   - MATLAB v4 to v7.3, HDF5 (datasets of the root) and numpy: every real vector; of a real matrix NAME, whose longer axis counts the
///     samples, NAME(1), NAME(2), … Units: ColumnUnits.
/// Throws InputError with line and column of a cell that is no number. Also for more than most_columns or 268 million numbers.
/// Also for a file of a format that is not read (other_format()), and for factors that titles or remarks state and nothing
/// applies. Also for variables that unpack to more than 64 times the file (64 MB in any case).
Columns read_columns(const std::filesystem::path& path);

}  // namespace jointid::frf
