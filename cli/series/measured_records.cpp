#include "cli/series/measured_records.hpp"

#include "cli/options/output.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {

void check_series_targets(const std::filesystem::path& file, const std::vector<std::pair<std::string, Target>>& targets) {
  check_targets({{file, "FILE"}}, targets);
}

std::string record_csv(const records::SeriesRecord& record) {
  std::vector<std::string> row = {"time [s]"};
  for (const auto& [name, unit] : record.channels) row.push_back(unit.empty() ? name : name + " [" + unit + "]");
  std::string text = report::csv_line(row);
  for (std::size_t i = 0; i < record.samples.front().size(); ++i) {
    row = {report::csv_number(static_cast<double>(i) / record.rate_hz)};
    for (const std::vector<double>& channel : record.samples) row.push_back(report::csv_number(channel[i]));
    text += report::csv_line(row);
  }
  return text;
}

}  // namespace jointid::cli
