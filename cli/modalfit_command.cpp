#include "cli/commands.hpp"
#include "cli/failure.hpp"
#include "cli/modalfit_text.hpp"
#include "cli/output.hpp"
#include "cli/report/modalfit_report.hpp"

namespace jointid::cli {
namespace {

Target text_of(const std::optional<std::filesystem::path>& path) { return path ? Target(path->string()) : std::nullopt; }

}  // namespace

ExitCode execute(const ModalfitArguments& arguments, std::ostream& out) {
  for (const auto& file : arguments.files) {
    check_targets(file, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report},
                         {"--regenerate", text_of(arguments.regenerate)}, {"--shapes", text_of(arguments.shapes)}});
  }
  const ModalRun run = run_modalfit(arguments);
  if (arguments.regenerate) write_regenerated(run, *arguments.regenerate);
  if (arguments.shapes) write_shapes(run, *arguments.shapes);
  if (arguments.json) write_target(*arguments.json, modalfit_json(run), out);
  if (arguments.csv) write_target(*arguments.csv, modes_csv(run), out);
  if (arguments.report) write_target(*arguments.report, report::modalfit_report(run), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << modalfit_text(run);
  if (run.fit.status == modalfit::FitStatus::ok) return ExitCode::done;
  print_error(run.files + ": " + run.fit.message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
