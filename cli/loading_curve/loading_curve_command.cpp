#include "cli/loading_curve/loading_curve_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/loading_curve/loading_curve_page.hpp"
#include "report/loading_curve/loading_curve_text.hpp"
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

}  // namespace

void add_loading_curve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<LoadingCurveArguments>(app, chosen, "loading-curve", "Find the law of a friction joint from measured curves");
  declare(*command, *arguments);
}

ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out) {
  check(arguments);
  const tasks::LoadingCurveResult result = fitted(arguments, out);
  write(arguments, result, out);
  if (tasks::some_usable(result)) return ExitCode::done;
  print_error(result.title + ": " + result.fits.front().message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
