#pragma once

#include <filesystem>

namespace jointid::cli {

/// Whether jointid may have written a file, by its head: a page, table, JSON or data file of the forms that it writes, or an
/// empty file. `record`: also records and motions, whose tables look like anybody's.
bool is_own_file(const std::filesystem::path& file, bool record = false);

/// Of a page as PDF: what is appended to it so that is_own_file() knows it.
inline constexpr const char* pdf_mark = "% jointid report\n";

}  // namespace jointid::cli
