#include "cli/modalfit/modalfit_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "report/modalfit/modal_page.hpp"
#include "report/modalfit/modal_text.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::cli {
namespace {

Target text_of(const std::optional<std::filesystem::path>& path) { return path ? Target(path->string()) : std::nullopt; }

tasks::ModalRun fitted(const ModalfitArguments& arguments) {
  Progress progress;
  modalfit::FitOptions options = arguments.fit;
  options.progress = [&progress](const char* stage) { progress.show(stage); };
  options.interrupted = interrupted;
  return tasks::run_modal_files(arguments.files, arguments.open, options);
}

}  // namespace

void add_modalfit(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ModalfitArguments>(
      app, chosen, "modalfit", "Identify modes from measured FRFs (modal analysis), and synthesise FRFs");
  declare(*command, *arguments);
}

ExitCode execute(const ModalfitArguments& arguments, std::ostream& out) {
  std::vector<ident::NamedFile> inputs;
  for (const auto& file : arguments.files) inputs.push_back({file, "FILES"});
  check_targets(inputs, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report},
                         {"--regenerate", text_of(arguments.regenerate)}, {"--shapes", text_of(arguments.shapes)}});
  const tasks::ModalRun run = fitted(arguments);
  const bool complete = !interrupted();  // files that could not say that they are not are left out
  if (arguments.regenerate && complete) write_regenerated(run, *arguments.regenerate);
  if (arguments.shapes && complete) write_shapes(run, *arguments.shapes);
  if (arguments.json) write_target(*arguments.json, report::modal_json(run), out);
  if (arguments.csv) write_target(*arguments.csv, report::modes_csv(run), out);
  if (arguments.report) write_target(*arguments.report, report::modal_page(run), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::modal_text(run);
  if (!complete) throw Interrupted("interrupted; what was fitted so far is written");
  return tell_status(run.files, run.fit.status, run.fit.message);
}

}  // namespace jointid::cli
