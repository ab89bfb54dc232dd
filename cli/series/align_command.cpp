#include "cli/options/output.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/progress.hpp"
#include "report/series/align_report.hpp"

namespace jointid::cli {

ExitCode execute(const SeriesAlignArguments& arguments, std::ostream& out) {
  check_targets({{arguments.file, "FILE"}},
                {{"--output", arguments.output}, {"--json", arguments.json}, {"--report", arguments.report}}, true);
  const tasks::AlignResult found = [&] {
    Progress progress;
    return tasks::run_align(arguments, progress.control());
  }();
  if (arguments.output) write_target(*arguments.output, report::align_csv(found), out);
  if (arguments.json) write_target(*arguments.json, report::align_json(found), out);
  if (arguments.report) write_target(*arguments.report, report::align_page(found), out);
  if (!takes_output({arguments.output, arguments.json, arguments.report})) out << report::align_text(found);
  return ExitCode::done;
}

}  // namespace jointid::cli
