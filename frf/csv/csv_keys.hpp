#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace jointid::frf {

/// Keys of a table of text by their proper names.
using CsvKeys = std::map<std::string, std::string, std::less<>>;

/// Takes the key and the value of a comment `# key = value` or `# key: value` into `keys`; any other comment is only that. `line`
/// is line `number` of `file`. Throws InputError where the key is nearly one that is read, and where a key stands there twice
/// with two values.
void read_csv_key(std::string_view line, const std::string& file, std::size_t number, CsvKeys& keys);

}  // namespace jointid::frf
