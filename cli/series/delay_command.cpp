#include "cli/options/output.hpp"
#include "cli/series/delay_report.hpp"
#include "cli/series/measured_records.hpp"
#include "cli/series/series_command.hpp"

namespace jointid::cli {

ExitCode execute(const SeriesDelayArguments& arguments, std::ostream& out) {
  check_series_targets(arguments.file, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const DelayReport report = [&] {
    Progress progress;
    return delay_report(arguments, progress);
  }();
  if (arguments.json) write_target(*arguments.json, delay_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, delay_csv(report), out);
  if (arguments.report) write_target(*arguments.report, delay_page(report), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << delay_text(report);
  return ExitCode::done;
}

}  // namespace jointid::cli
