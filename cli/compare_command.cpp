#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/compare_arguments.hpp"
#include "cli/comparison_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report/comparison_report.hpp"
#include "cli/report/reproduction_report.hpp"
#include "cli/reproduction_text.hpp"

namespace jointid::cli {
namespace {

/// Trials as asked, with progress on `progress` and Ctrl-C.
ident::TrialOptions watched(const CompareArguments& arguments, Progress& progress) {
  catch_interrupts();
  return {.trials = arguments.trials,
          .seed = arguments.seed,
          .threads = arguments.threads,
          .progress = [&progress](std::size_t done, std::size_t total) {
            progress.show(fmt::format("trial {} of {}", done, total));
          },
          .interrupted = interrupted};
}

ComparisonReport compared(const CompareArguments& arguments, const ident::Scene& scene) {
  const auto lists = alternatives(arguments);
  Progress progress;
  return {scene.title, arguments.trials, arguments.seed,
          ident::compare(scene, ident::combinations(scene.identify, lists, scene.data.regenerate), ident::load_trial_data,
                         watched(arguments, progress))};
}

ReproductionReport reproduced(const CompareArguments& arguments) {
  const problems::ThesisTable& table = problems::thesis_table(arguments.reproduce);
  Progress progress;
  return {table, arguments.trials, arguments.seed, problems::reproduce(table, watched(arguments, progress))};
}

void write(const CompareArguments& arguments, std::ostream& out, const std::string& text, const std::string& json,
           const std::string& csv, const std::string& page) {
  if (arguments.json) write_target(*arguments.json, json, out);
  if (arguments.csv) write_target(*arguments.csv, csv, out);
  if (arguments.report) write_target(*arguments.report, page, out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << text;
}

bool some_usable(const std::vector<ident::Combination>& combinations) {
  return std::ranges::any_of(combinations, [](const auto& each) { return each.statuses.contains(ident::Status::ok); });
}

}  // namespace

ExitCode execute(const CompareArguments& arguments, std::ostream& out) {
  check(arguments);
  if (arguments.reproduce == "list") {
    out << table_list();
    return ExitCode::done;
  }
  if (!arguments.reproduce.empty()) {
    const ReproductionReport report = reproduced(arguments);
    write(arguments, out, reproduction_text(report), reproduction_json(report), reproduction_csv(report),
          report::reproduction_report(report));
    return ExitCode::done;
  }
  const ident::Scene scene = ident::read_scene(arguments.scene);
  const ComparisonReport report = compared(arguments, scene);
  write(arguments, out, comparison_text(report), comparison_json(report), comparison_csv(report),
        report::comparison_report(report, scene));
  return some_usable(report.comparison.combinations) ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
