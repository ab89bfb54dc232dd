#include "cli/response/response_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/response/comparison_run.hpp"
#include "cli/response/read_response_scene.hpp"
#include "cli/response/response_text.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/progress.hpp"

namespace jointid::cli {

void add_response(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ResponseArguments>(
      app, chosen, "response",
      "Find the periodic response of a structure with friction joints, from FRFs of its parts or from matrices");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] or [structure], [[joints]], [force], [response]")
      ->required();
  add_outputs(command, *arguments, "the responses, joints and peaks", "the harmonics of the responses");
  command->add_option("--history", arguments->history, "Write the motions of [transient] as CSV to a file, or - for stdout");
  command->add_flag("--compare", arguments->compare,
                    "Instead: error against run time of harmonic balance, Algorithms One and Two, against the exact orbit");
  command->footer("Example:\n  jointid response rig.toml --csv response.csv");
}

namespace {

ExitCode compare(const ResponseArguments& arguments, const ResponseScene& scene, std::ostream& out) {
  const std::vector<WaysRun> runs = [&] {
    Progress progress;
    return run_comparison(scene, progress);
  }();
  if (arguments.json) write_target(*arguments.json, comparison_json(scene, runs), out);
  if (arguments.csv) write_target(*arguments.csv, comparison_csv(runs), out);
  if (!takes_output({arguments.json, arguments.csv})) out << comparison_text(scene, runs);
  if (all_known(runs)) return ExitCode::done;
  print_error(arguments.scene.string() + ": no exact orbit was found");
  return ExitCode::unusable;
}

}  // namespace

ExitCode execute(const ResponseArguments& arguments, std::ostream& out) {
  const ResponseScene scene = read_response_scene(arguments.scene);
  check_targets(files_of(scene), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--history", arguments.history}});
  if (arguments.compare) return compare(arguments, scene, out);
  if (arguments.history && !scene.transient) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = arguments.scene.string(),
                      .place = "--history",
                      .problem = "the scene has no [transient]",
                      .remedy = "add one, or leave --history out"});
  }
  const ResponseRun run = [&] {
    Progress progress;
    return run_response(scene, progress);
  }();
  if (arguments.json) write_target(*arguments.json, response_json(scene, run), out);
  if (arguments.csv) write_target(*arguments.csv, response_csv(run), out);
  if (arguments.history) write_target(*arguments.history, history_csv(run), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.history})) out << response_text(scene, run);
  if (all_converged(run)) return ExitCode::done;
  print_error(arguments.scene.string() + ": harmonic balance did not converge everywhere");
  return ExitCode::unusable;
}

}  // namespace jointid::cli
