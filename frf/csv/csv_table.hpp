#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// The first column of a table of FRFs.
inline constexpr const char* csv_frequency_column = "frequency_hz";

/// A table of numbers with named columns, as it stands in a text file.
struct CsvTable {
  std::string file;
  std::map<std::string, std::string, std::less<>> keys;  ///< from lines `# key = value`
  std::vector<std::string> columns;
  std::size_t header_line = 0;     ///< line of the column names, from 1
  std::vector<std::size_t> lines;  ///< line of each row, from 1
  std::vector<double> cells;       ///< [rows, columns], NaN where empty

  std::size_t rows() const { return lines.size(); }
  double cell(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }

  /// "line 7, column 3"; columns from 0 inside, from 1 in messages.
  static std::string place(std::size_t line, std::size_t column);

  /// Throws InputError (data) at that cell.
  [[noreturn]] void fail(std::size_t line, std::size_t column, std::string problem, std::string remedy) const;
};

/// The separator of a line: semicolon, else tab, else comma; '\0' when it has none.
char csv_separator(std::string_view line);

/// Reads a table separated by comma, semicolon or tab; with semicolon numbers may have a decimal comma.
/// Throws InputError naming line and column of what is no finite number, and rows of another length than the
/// header.
CsvTable read_csv_table(const std::filesystem::path& path);

}  // namespace jointid::frf
