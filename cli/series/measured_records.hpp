#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/target.hpp"
#include "records/file/read_series.hpp"

namespace jointid::cli {

/// The file of FILES and the outputs, checked (check_targets()).
void check_series_targets(const std::filesystem::path& file, const std::vector<std::pair<std::string, Target>>& targets);

/// "time [s],NAME [unit],…" and a row a sample; missing samples are empty cells.
std::string record_csv(const records::SeriesRecord& record);

}  // namespace jointid::cli
