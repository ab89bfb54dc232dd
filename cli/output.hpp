#pragma once

#include <filesystem>
#include <ostream>
#include <string>

namespace jointid::cli {

/// Writes under a temporary name beside `path` and renames, so that nobody sees half a file; when that fails the old
/// file stays and the temporary one is removed. Throws InputError (data).
void write_file(const std::filesystem::path& path, const std::string& text);

/// Writes to `out` when the target is "-", else to the file of that name.
void write_target(const std::string& target, const std::string& text, std::ostream& out);

}  // namespace jointid::cli
