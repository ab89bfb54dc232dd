#include "cli/stability/stability_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/options/whole_number.hpp"
#include "cli/stability/stability_page.hpp"
#include "cli/stability/stability_report.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"

namespace jointid::cli {
namespace {

void write(const StabilityArguments& arguments, const StabilityReport& report, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, stability_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, stability_csv(report), out);
  if (arguments.report) write_target(*arguments.report, stability_report(report), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << stability_text(report);
}

/// Writes the rows that were measured when the command was interrupted.
std::string save(const StabilityArguments& arguments, std::optional<StabilityReport> done, std::ostream& out) {
  if (!done) return "interrupted";
  done->interrupted = true;
  write(arguments, *done, out);
  return "interrupted; what was measured so far is written";
}

StabilityReport measured(const StabilityArguments& arguments, std::ostream& out) {
  SoFar<StabilityReport> done;
  Progress progress;
  StabilityReport report;
  report.seed = arguments.seed;
  const stability::Watch watch{.progress = [&progress](const std::string& what) { progress.show(what); },
                               .interrupted = interrupted,
                               .measured =
                                   [&](const stability::Measured& row) {
                                     report.rows.push_back(row);
                                     done.put(report);
                                   },
                               .counted =
                                   [&](const stability::Count& count) {
                                     report.count = count;
                                     done.put(report);
                                   }};
  with_last_words([&] { return save(arguments, done.get(), out); },
                  [&] {
                    stability::run_sweeps(arguments.sweeps, watch);
                    report.count = stability::count_verdicts(arguments.seed, 0, arguments.scenes, watch);
                  });
  return report;
}

bool keeps_silent(const StabilityReport& report) {
  for (const stability::Measured& row : report.rows) {
    if (row.verdict == stability::Honesty::silent_wrong) return true;
  }
  return report.count.silent_wrong > 0;
}

}  // namespace

void add_stability(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<StabilityArguments>(
      app, chosen, "stability", "Measure how many digits every solver keeps on extreme cases, against 50-digit arithmetic");
  command->add_option("--sweeps", arguments->sweeps, "Run only these sweeps, e.g. stiffness,lines")->delimiter(',');
  add_whole_number(command, "--scenes", arguments->scenes, "How many extreme scenes to draw at random", counts_of_trials());
  add_whole_number(command, "--seed", arguments->seed, "Seed of the random scenes", {});
  add_outputs(command, *arguments, "all rows", "all rows", "tables and plots");
  command->footer("Examples:\n  jointid stability\n  jointid stability --sweeps stiffness --scenes 0 --report stability.html");
}

ExitCode execute(const StabilityArguments& arguments, std::ostream& out) {
  check_targets({}, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const StabilityReport report = measured(arguments, out);
  write(arguments, report, out);
  return keeps_silent(report) ? ExitCode::unusable : ExitCode::done;
}

}  // namespace jointid::cli
