#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Tables of numbers as they stand in text files.
namespace jointid::frf {

/// The whole file. Throws InputError when it cannot be read.
std::string read_text(const std::filesystem::path& path);

/// Without blanks around it and, for column names, without quotes.
std::string_view trimmed(std::string_view text);

/// Takes the part of `rest` before `end` off it, and `end` itself.
std::string_view take_until(std::string_view& rest, char end);

/// The cells of a line; between blanks (`separator` ' ') any number of them counts as one.
std::vector<std::string_view> split(std::string_view line, char separator);

/// A finite number, or NaN for an empty cell or one that says NaN; false for anything else. Exponents may begin with D (Fortran,
/// "1.2D-03") or, of three digits, with their sign alone ("1.2-103"); a minus may be the sign of typesetting (U+2212), and blanks
/// that do not break may stand around the number.
bool parse_cell(std::string_view cell, bool decimal_comma, double& value);

}  // namespace jointid::frf
