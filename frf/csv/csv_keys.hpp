#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// Keys of a table of text by their proper names.
using CsvKeys = std::map<std::string, std::string, std::less<>>;

/// Takes the key and the value of a comment `# key = value` or `# key: value` into `keys`; any other comment is only that. `line`
/// is line `number` of `file`. Throws InputError where the key is nearly one that is read, where a key stands there twice with
/// two values, and, unless the user gives the unit (`unit_given`), where a comment is the unit of an FRF that nothing reads.
void read_csv_key(std::string_view line, const std::string& file, std::size_t number, bool unit_given, CsvKeys& keys);

/// Throws InputError where a line of a table states a factor that nothing applies, "scale = 0.001" and "values x 1000", or conjugates.
void require_no_scale(const std::string& key, const std::string& value, const std::string& file, std::size_t number);

/// "'mV/N' is no unit of an FRF that is known", and what may have been meant.
std::string unknown_unit(const std::string& label);

/// A line above the row of titles, by its first separator, colon or equal sign; one without any is all value.
struct CsvNote {
  std::size_t line = 0;
  std::string key, value;
};
CsvNote csv_note(std::string_view line, std::size_t number, char separator);

/// Takes what free lines above the titles say of units, averages and quantity into `keys`, which come before: "Units;g/N", "Y
/// Unit: g/lbf", "X unit = kHz", "Averages,10"; all others are passed over. `units` are those of the columns, the first that of
/// the frequencies. Throws InputError that names line and text of a unit that is not understood, or of no FRF, where neither the
/// columns nor the user give one, of two units that differ, and of decibels.
void read_csv_notes(const std::vector<CsvNote>& notes, const std::string& file, const std::vector<std::string>& units,
                    bool unit_given, CsvKeys& keys);

}  // namespace jointid::frf
