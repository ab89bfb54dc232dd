#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "frf/csv/csv_keys.hpp"
#include "frf/csv/csv_titles.hpp"

namespace jointid::frf {

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
  std::vector<std::size_t> places;  ///< of each column in the file, from 0
  std::vector<std::string> doubts;  ///< what lines below the rows say against the data

  std::size_t rows() const { return lines.size(); }
  double cell(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }

  /// "line 7, column 3" of the file; columns from 0 inside, from 1 in messages.
  std::string place(std::size_t line, std::size_t column) const;

  /// Throws InputError (data) at that cell.
  [[noreturn]] void fail(std::size_t line, std::size_t column, std::string problem, std::string remedy) const;
};

/// What the user says in place of what a table does.
struct CsvGiven {
  bool unit = false;           ///< a unit of the FRFs: comments that look like one are only comments
  std::string frequency_unit;  ///< empty: as the table says; else the first column holds frequencies, whatever its title
};

/// Reads the table of a text (read_plain_text()), separated by comma, semicolon or tab (tabs_for_blanks()), or as a first line
/// `sep=;` says. Free lines may stand above the row of titles (find_csv_header(), read_csv_notes()) and below the
/// rows (is_footer()); marks of pages and the same titles again may stand between them. Cells may stand in quotes;
/// numbers may have decimal commas where these do not separate, all of them or none. The first column is the frequency:
/// `frequency_hz`, "Frequency [Hz]", "Freq (kHz)", "f [Hz]", "omega"; one before it that counts the rows and empty ones at the
/// end are passed over. A column of complex numbers (parse_complex(), parse_polar(); angles without a unit are
/// degrees where one is above 30) becomes two, with re and im behind its title. What stands
/// in place of a number that is none (states_no_value()) is NaN. Keys: quantity, unit, averages, frequency_unit and node N, in
/// any case, with = or :, also units for unit; lines `# key = value` with any other key are comments, but for keys that look like
/// these. Throws InputError naming line and column of what is no finite number, rows of another length than the header, a unit
/// that is not understood and a key that is nearly one.
CsvTable read_csv_table(const std::string& file, std::string_view text, const CsvGiven& given = {});

}  // namespace jointid::frf
