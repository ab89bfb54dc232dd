#include "cli/loading_curve/loading_curve_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/loading_curve/loading_curve_page.hpp"
#include "cli/loading_curve/loading_curve_report.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/loading_curve/loading_curve_fit.hpp"
#include "report/loading_curve/loading_curve_report.hpp"

namespace jointid::cli {
namespace {

void write(const LoadingCurveArguments& arguments, const report::LoadingCurveReport& report, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, loading_curve_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, loading_curve_csv(report), out);
  if (arguments.report) write_target(*arguments.report, loading_curve_report(report), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << loading_curve_text(report);
}

/// Writes the laws that were fitted when the command was interrupted.
std::string save(const LoadingCurveArguments& arguments, std::optional<report::LoadingCurveReport> done, std::ostream& out) {
  if (!done) return "interrupted";
  done->data.notes.push_back("INTERRUPTED: only the laws that were fitted so far");
  write(arguments, *done, out);
  return "interrupted; the laws that were fitted so far are written";
}

report::LoadingCurveReport fitted(const LoadingCurveArguments& arguments, std::ostream& out) {
  SoFar<report::LoadingCurveReport> done;
  Progress progress;
  const report::FittingWatch watch{interrupted, [&](const std::string& stage) { progress.show(stage); },
                                   [&](const report::LoadingCurveReport& report) { done.put(report); }};
  return with_last_words([&] { return save(arguments, done.get(), out); },
                         [&] { return report::fit_loading_curves(arguments, watch); });
}

}  // namespace

void add_loading_curve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<LoadingCurveArguments>(app, chosen, "loading-curve", "Find the law of a friction joint from measured curves");
  declare(*command, *arguments);
}

ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out) {
  check(arguments);
  const report::LoadingCurveReport report = fitted(arguments, out);
  write(arguments, report, out);
  if (some_usable(report)) return ExitCode::done;
  print_error(report.title + ": " + report.fits.front().message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
