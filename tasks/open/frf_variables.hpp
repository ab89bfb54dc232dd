#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jointid::tasks {

/// The variables of a file of named arrays among which somebody has to choose: each may be the FRFs (OpenOptions::variable, in a scene
/// `variable`). Empty where the file says by itself which one it is, and where none may be.
std::vector<std::string> frf_variables(const std::filesystem::path& file);

}  // namespace jointid::tasks
