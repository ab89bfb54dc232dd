#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frf/csv/csv_parts.hpp"

namespace jointid::frf {

/// The first column of a table of FRFs.
inline constexpr const char* csv_frequency_column = "frequency_hz";

/// The separator of a line: semicolon, else tab, else comma; '\0' when it has none.
char csv_separator(std::string_view line);

/// The unit "(A)(B)" of analysers as "(A)/(B)".
std::string as_ratio(std::string unit);

/// The cells of a line, of which some may stand in quotes with separators inside; views into the line.
std::vector<std::string_view> csv_cells(std::string_view line, char separator);

/// Whether all cells name types or formats of numbers, "DT_DOUBLE", "float64", "Format=0.000": a row that LabVIEW, Testlab, catman and
/// databases write under the titles.
bool are_types(const std::vector<std::string_view>& cells);

/// A cell of the row of titles as one.
CsvTitle csv_title(std::string_view cell);

/// The same of the first column: "Freq_kHz" has the unit kHz, "omega" rad/s; empty where it is no title of frequencies.
std::optional<CsvTitle> frequency_title(std::string_view cell);

/// Where the row of titles stands in a text.
struct CsvHeaderPlace {
  std::size_t line = 0;   ///< from 1
  char separator = '\0';  ///< of its cells
  std::size_t index = 0;  ///< columns before the frequencies that only count the rows: 0 or 1
  bool any_axis = false;  ///< its first cell is no title of frequencies, "X": a unit has to say that they are
};

/// The row of titles of a table of FRFs: the last one above the numbers whose first cell is a title of frequencies ("Frequency
/// [Hz]"), or whose second is behind a title that counts rows ("", "Unnamed: 0", "index", "No."). What stands above it is free
/// text. It may stand in a comment. Where there is none, or nothing but units ("Hz", "g/N"), the last row of as many cells as the
/// numbers have that names parts ("X", "Real", "Imag"). A separator that is given counts for all lines. Empty where there is none in
/// the first lines.
std::optional<CsvHeaderPlace> find_csv_header(std::string_view text, char separator = '\0');

/// What to do about a table without titles.
inline constexpr std::string_view write_titles =
    "write one above them, with the same sign between its cells, e.g. 'Frequency [Hz]', 'Real [m/s^2/N]', 'Imaginary [m/s^2/N]', or "
    "Magnitude and Phase [deg]. A column before them that counts the lines is titled No. Or export a universal file (UFF 58)";

/// The first line of numbers of a text that has no row of titles above it; 0 where there is none.
std::size_t line_without_titles(std::string_view text);

}  // namespace jointid::frf
