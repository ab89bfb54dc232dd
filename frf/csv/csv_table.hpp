#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "frf/csv/csv_keys.hpp"

namespace jointid::frf {

/// The first column of a table of FRFs.
inline constexpr const char* csv_frequency_column = "frequency_hz";

/// A table of numbers with named columns, as it stands in a text file.
struct CsvTable {
  std::string file;
  CsvKeys keys;  ///< from lines `# key = value`
  std::vector<std::string> columns;
  std::vector<std::string>
      units;  ///< of each column: "Hz" of a title "Frequency [Hz]", or as a row under the titles says it; else empty
  double hz_per_unit = 1.0;        ///< of the first column
  std::size_t header_line = 0;     ///< line of the column names, from 1
  std::size_t units_line = 0;      ///< of a row of units under it, or that line
  std::vector<std::size_t> lines;  ///< line of each row, from 1
  std::vector<double> cells;       ///< [rows, columns], NaN where empty

  std::size_t rows() const { return lines.size(); }
  double cell(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }

  /// "line 7, column 3"; columns from 0 inside, from 1 in messages.
  static std::string place(std::size_t line, std::size_t column);

  /// Throws InputError (data) at that cell.
  [[noreturn]] void fail(std::size_t line, std::size_t column, std::string problem, std::string remedy) const;
};

/// The whole of a text file as UTF-8, without a byte-order mark; UTF-16 is converted. Throws InputError when it cannot be read.
std::string read_csv_text(const std::filesystem::path& path);

/// The separator of a line: semicolon, else tab, else comma; '\0' when it has none.
char csv_separator(std::string_view line);

/// Reads a table separated by comma, semicolon or tab, or as a first line `sep=;` says. Cells may stand in quotes; numbers may
/// have decimal commas where these do not separate, all of them or none. The first column is the frequency: `frequency_hz`,
/// "Frequency [Hz]", "Freq (kHz)", "f [Hz]", "omega". Keys: quantity, unit, averages, frequency_unit and node N, in any case,
/// with = or :, also units for unit; lines
/// `# key = value` with any other key are comments, but for keys that look like these. Throws InputError naming line and column
/// of what is no finite number, rows of another length than the header, a unit that is not understood and a key that is nearly
/// one.
CsvTable read_csv_table(const std::filesystem::path& path);

}  // namespace jointid::frf
