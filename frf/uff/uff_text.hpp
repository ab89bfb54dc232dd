#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Text as UFF files hold it: Fortran columns, Fortran numbers, Latin-1 or UTF-8 headers.
namespace jointid::frf::uff {

/// Without blanks, tabs, line ends, and the NULs and end-of-file bytes (Ctrl-Z) with which some programs fill fields and files,
/// on either side.
std::string_view trim(std::string_view text);

/// The line with one byte per column: valid UTF-8 becomes Latin-1 (characters beyond it '?'), anything else
/// is taken for Latin-1 already. Fields after a name with an umlaut then stand where the format says.
std::string one_byte_per_column(std::string_view line);

/// Latin-1 to UTF-8.
std::string to_utf8(std::string_view latin1);

/// Columns [begin, begin + width) of the line, trimmed; beyond the end of the line all is blank.
std::string_view column(std::string_view line, std::size_t begin, std::size_t width);

/// The same columns with one character of valid UTF-8 a column, as UTF-8; of bytes otherwise, which are then Latin-1.
std::string text_column(std::string_view line, std::size_t begin, std::size_t width);

/// Whether the line is valid UTF-8 with characters of several bytes, so that columns of characters are not those of bytes.
bool has_wide_characters(std::string_view line);

/// The blank-separated words of a line.
std::vector<std::string_view> words(std::string_view line);

/// Three columns of that width; of a line that is three words from its begin on, those, whatever their columns.
std::array<std::string_view, 3> three_fields(std::string_view line, std::size_t begin, std::size_t width);

/// A whole decimal integer; blank is 0 as in Fortran.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// A whole Fortran real: exponents with E, D, either case, or with their sign only (1.0+100). Too small is 0;
/// too large, blank or anything else is empty.
std::optional<double> parse_real(std::string_view text);

/// A number as nearly all files write them, as -1.23456E-07: the double next to it, by one product or quotient of numbers that are
/// exact (Clinger 1990). False where one is not, up to 15 digits and powers of ten up to 22, or [first, last) is of another form.
bool parse_short_real(const char* first, const char* last, double& value);

/// A value of a data line: parse_real(), or what special_number() knows: NaN, 1.#QNAN, -1.#IND, ***, infinite.
std::optional<double> parse_value(std::string_view text);

/// The line that opens and closes every dataset: -1 in the first six columns and nothing else.
bool is_delimiter(std::string_view line);

}  // namespace jointid::frf::uff
