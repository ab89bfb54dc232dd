#include "cli/options/output.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/progress.hpp"
#include "report/series/reversal_report.hpp"

namespace jointid::cli {

ExitCode execute(const SeriesReversalArguments& arguments, std::ostream& out) {
  check_targets({{arguments.file, "FILE"}}, {{"--json", arguments.json}, {"--report", arguments.report}});
  const tasks::ReversalResult found = [&] {
    Progress progress;
    return tasks::run_reversal(arguments, progress.control());
  }();
  if (arguments.json) write_target(*arguments.json, report::reversal_json(found), out);
  if (arguments.report) write_target(*arguments.report, report::reversal_page(found), out);
  if (!takes_output({arguments.json, arguments.report})) out << report::reversal_text(found);
  return ExitCode::done;
}

}  // namespace jointid::cli
