#pragma once

#include <filesystem>
#include <string>

namespace jointid::frf {

/// The whole of a text file as UTF-8, without a byte-order mark, end-of-file bytes of DOS and NULs at its end; UTF-16 is
/// converted. Throws InputError when it cannot be read.
std::string read_csv_text(const std::filesystem::path& path);

}  // namespace jointid::frf
