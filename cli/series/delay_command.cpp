#include "cli/options/output.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/progress.hpp"
#include "report/series/delay_report.hpp"

namespace jointid::cli {

ExitCode execute(const SeriesDelayArguments& arguments, std::ostream& out) {
  check_targets({{arguments.file, "FILE"}},
                {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const tasks::DelayResult found = [&] {
    Progress progress;
    return tasks::run_delay(arguments, progress.control());
  }();
  if (arguments.json) write_target(*arguments.json, report::delay_json(found), out);
  if (arguments.csv) write_target(*arguments.csv, report::delay_csv(found), out);
  if (arguments.report) write_target(*arguments.report, report::delay_page(found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::delay_text(found);
  return ExitCode::done;
}

}  // namespace jointid::cli
