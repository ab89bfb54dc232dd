#include "cli/laws/laws_run.hpp"

#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_text.hpp"

namespace jointid::cli {

ExitCode tell_status(const laws::LawScene& scene, laws::LawStatus status, const std::string& message) {
  if (status == laws::LawStatus::ok) return ExitCode::done;
  const std::string what = scene.file.string() + ": ";
  if (laws::is_usable(status)) {
    print_warning(what + "doubtful: " + message);
    return ExitCode::done;
  }
  print_error(what + message);
  return ExitCode::unusable;
}

ExitCode solve_laws(const laws::LawScene& scene, const LawTargets& targets, std::size_t threads, std::ostream& out) {
  check_targets(laws::files_of(scene), {{"--json", targets.json}, {"--csv", targets.csv}, {"--report", targets.report}});
  const response::FitWork work = {.threads = threads, .interrupted = interrupted};
  const laws::LawIdentification found = with_progress("fitting friction laws", [&] { return laws::identify_laws(scene, work); });
  if (targets.json) write_target(*targets.json, report::law_json(scene, found), out);
  if (targets.csv) write_target(*targets.csv, report::law_csv(scene, found), out);
  if (targets.report) write_target(*targets.report, report::law_page(scene, found), out);
  if (!takes_output({targets.json, targets.csv, targets.report})) out << report::law_text(scene, found);
  return tell_status(scene, found.status, found.message);
}

}  // namespace jointid::cli
