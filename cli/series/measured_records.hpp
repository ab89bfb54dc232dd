#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/target.hpp"

namespace jointid::cli {

/// The file of FILES and the outputs, checked (check_targets()).
void check_series_targets(const std::filesystem::path& file, const std::vector<std::pair<std::string, Target>>& targets);

}  // namespace jointid::cli
