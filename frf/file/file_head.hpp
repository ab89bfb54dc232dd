#pragma once

#include <filesystem>
#include <string>

namespace jointid::frf {

/// The first 4096 bytes of a file, by which its format is told; fewer of a shorter one, none of one that cannot be read.
std::string head_of(const std::filesystem::path& path);

/// By the first bytes, whatever the file's name.
bool is_universal_file(const std::filesystem::path& path);

}  // namespace jointid::frf
