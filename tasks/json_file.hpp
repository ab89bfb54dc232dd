#pragma once

#include <filesystem>

namespace jointid::tasks {

/// Whether a file is a JSON object, by its first letter.
bool is_json_file(const std::filesystem::path& file);

}  // namespace jointid::tasks
