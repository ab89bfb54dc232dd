#pragma once

#include <filesystem>
#include <string>

namespace jointid::records {

/// The first 512 bytes of a file, by which its format is told; fewer of a shorter one.
std::string head_of(const std::filesystem::path& path);

}  // namespace jointid::records
