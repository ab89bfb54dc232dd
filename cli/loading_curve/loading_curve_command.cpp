#include "cli/loading_curve/loading_curve_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "report/loading_curve/joint_history_text.hpp"
#include "report/loading_curve/loading_curve_page.hpp"
#include "report/loading_curve/loading_curve_text.hpp"
#include "tasks/joint_history/joint_history.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"

namespace jointid::cli {
namespace {

void write(const LoadingCurveArguments& arguments, const tasks::LoadingCurveResult& result, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, report::loading_curve_json(result), out);
  if (arguments.csv) write_target(*arguments.csv, report::loading_curve_csv(result), out);
  if (arguments.report) write_target(*arguments.report, report::loading_curve_page(result), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::loading_curve_text(result);
}

/// Writes the laws that were fitted when the command was interrupted.
std::string save(const LoadingCurveArguments& arguments, std::optional<tasks::LoadingCurveResult> done, std::ostream& out) {
  if (!done) return "interrupted";
  done->data.notes.push_back("INTERRUPTED: only the laws that were fitted so far");
  write(arguments, *done, out);
  return "interrupted; the laws that were fitted so far are written";
}

tasks::LoadingCurveResult fitted(const LoadingCurveArguments& arguments, std::ostream& out) {
  SoFar<tasks::LoadingCurveResult> done;
  Progress progress;
  const tasks::FittingWatch watch{interrupted, [&](const std::string& stage) { progress.show(stage); },
                                  [&](const tasks::LoadingCurveResult& result) { done.put(result); }};
  return with_last_words([&] { return save(arguments, done.get(), out); },
                         [&] { return tasks::fit_loading_curves(arguments, watch); });
}

/// A scene of a joint in place of curves: the forces along its history.
bool of_scene(const LoadingCurveArguments& arguments) {
  return arguments.files.size() == 1 && arguments.files.front().extension() == ".toml";
}

ExitCode move_joint(const LoadingCurveArguments& arguments, std::ostream& out) {
  const std::filesystem::path& file = arguments.files.front();
  if (arguments.report)
    throw InputError({ErrorKind::usage, file.string(), "--report", "a scene of a joint writes no page", "take --json or --csv"});
  check_targets({{file, "FILES"}}, {{"--json", arguments.json}, {"--csv", arguments.csv}});
  const tasks::JointHistoryScene scene = tasks::read_joint_history(file);
  const tasks::JointHistory history = tasks::run_joint_history(scene);
  if (arguments.json) write_target(*arguments.json, report::joint_history_json(scene, history), out);
  if (arguments.csv) write_target(*arguments.csv, report::joint_history_csv(scene, history), out);
  if (!takes_output({arguments.json, arguments.csv})) out << report::joint_history_text(scene, history);
  return ExitCode::done;
}

}  // namespace

void add_loading_curve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<LoadingCurveArguments>(app, chosen, "loading-curve", "Find the law of a friction joint from measured curves");
  declare(*command, *arguments);
}

ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out) {
  if (of_scene(arguments)) return move_joint(arguments, out);
  check(arguments);
  const tasks::LoadingCurveResult result = fitted(arguments, out);
  write(arguments, result, out);
  return tell_status(result.title, result.fits.front().status, result.fits.front().message);  // the best law stands first
}

}  // namespace jointid::cli
