#include "cli/series/measured_records.hpp"

#include "cli/options/output.hpp"

namespace jointid::cli {

void check_series_targets(const std::filesystem::path& file, const std::vector<std::pair<std::string, Target>>& targets) {
  check_targets({{file, "FILE"}}, targets);
}

}  // namespace jointid::cli
