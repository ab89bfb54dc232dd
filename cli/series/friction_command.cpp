#include "cli/options/output.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/progress.hpp"
#include "report/series/contact_report.hpp"

namespace jointid::cli {

ExitCode execute(const SeriesFrictionArguments& arguments, std::ostream& out) {
  check_targets({{arguments.file, "FILE"}},
                {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const tasks::ContactResult found = [&] {
    Progress progress;
    return tasks::run_contact(arguments, progress.control());
  }();
  if (arguments.json) write_target(*arguments.json, report::contact_json(found), out);
  if (arguments.csv) write_target(*arguments.csv, report::contact_csv(found), out);
  if (arguments.report) write_target(*arguments.report, report::contact_page(found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::contact_text(found);
  return ExitCode::done;
}

}  // namespace jointid::cli
