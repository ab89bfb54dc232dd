#include "cli/oscillate/oscillate_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/oscillate/oscillate_page.hpp"
#include "report/oscillate/oscillate_report.hpp"
#include "tasks/oscillate/run_oscillate.hpp"

namespace jointid::cli {
namespace {

void check_outputs(const OscillateArguments& arguments, const tasks::OscillateScene& scene) {
  check_targets(tasks::files_of(scene),
                {{"--json", arguments.json},
                 {"--csv", arguments.csv},
                 {"--report", arguments.report},
                 {"--sweep", arguments.sweep},
                 {"--events", arguments.events}},
                true);
}

void write(const OscillateArguments& arguments, const tasks::OscillateResult& run, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, report::oscillate_json(run), out);
  if (arguments.csv) write_target(*arguments.csv, report::motion_csv(run), out);
  if (arguments.sweep) write_target(*arguments.sweep, report::sweep_csv(run), out);
  if (arguments.events) write_target(*arguments.events, report::events_csv(run), out);
  if (arguments.report) write_target(*arguments.report, report::oscillate_report(run), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report, arguments.sweep, arguments.events}))
    out << report::oscillate_text(run);
}

/// Writes what was found when the command was interrupted.
std::string save(const OscillateArguments& arguments, std::optional<tasks::OscillateResult> done, std::ostream& out) {
  if (!done) return "interrupted";
  done->interrupted = true;
  done->remarks.emplace_back("INTERRUPTED: only what was found so far");
  write(arguments, *done, out);
  return "interrupted; what was found so far is written";
}

}  // namespace

void add_oscillate(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<OscillateArguments>(
      app, chosen, "oscillate", "Integrate a stick-slip motion exactly: orbits, exponents, bifurcations, reduced models");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [system], [friction], [motion]")->required();
  add_whole_number(command, "--threads", arguments->threads, "Threads of the sweep, 0 for all cores; the results do not depend on them",
                   counts_of_threads());
  command->add_option("--sweep", arguments->sweep, "Write the bifurcation diagram as CSV to a file, or - for stdout");
  command->add_option("--events", arguments->events,
                      "Write the break-aways or cycles of the Poincaré section as CSV to a file, or - for stdout");
  add_outputs(command, *arguments, "all results", "the samples of the motion", "plots and tables");
  command->footer(
      "Examples:\n  jointid problem write chain-10 chain && jointid oscillate chain/chain-10.toml --report chain.html");
}

ExitCode execute(const OscillateArguments& arguments, std::ostream& out) {
  const tasks::OscillateScene scene = tasks::read_oscillate_scene(arguments.scene);
  check_outputs(arguments, scene);
  if (arguments.sweep && !scene.sweep) {
    throw InputError({ErrorKind::usage, "", "--sweep", "the scene has no [sweep]", "add one, or leave --sweep out"});
  }
  SoFar<tasks::OscillateResult> done;
  const auto save_so_far = [&] { return save(arguments, done.get(), out); };
  const tasks::OscillateResult run = with_last_words(save_so_far, [&] {
    Progress progress;
    ident::Control control;
    control.threads = arguments.threads;
    control.interrupted = interrupted;
    control.progress = [&](const std::string& stage, std::size_t percent, std::size_t total) {
      progress.show(total == 0 ? stage : fmt::format("{}: {} %", stage, percent));
    };
    return run_oscillate(scene, control, [&](const tasks::OscillateResult& found) { done.put(found); });
  });
  write(arguments, run, out);
  const std::string failure = tasks::failure_of(run);
  if (failure.empty()) return ExitCode::done;
  print_error(arguments.scene.string() + ": " + failure);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
