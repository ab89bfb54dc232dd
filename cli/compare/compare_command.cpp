#include "cli/compare/compare_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/parallel.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/problem/reproduction_page.hpp"
#include "cli/problem/reproduction_text.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "ident/scene/read_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "report/laws/law_comparison_text.hpp"
#include "report/result/comparison_page.hpp"
#include "report/result/comparison_text.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"
#include "tasks/compare/compare_ways.hpp"

namespace jointid::cli {
namespace {

/// Trials as asked, with progress on `progress` and Ctrl-C.
study::TrialOptions watched(const CompareArguments& arguments, Progress& progress) {
  return {.trials = arguments.trials,
          .seed = arguments.seed,
          .threads = arguments.threads,
          .progress = [&progress](std::size_t done, std::size_t total) {
            progress.show(fmt::format("trial {} of {}", done, total));
          },
          .interrupted = interrupted};
}

void check_outputs(const CompareArguments& arguments, const std::vector<ident::NamedFile>& inputs) {
  check_targets(inputs, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
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

void write(const CompareArguments& arguments, std::ostream& out, const tasks::ComparisonResult& result, const ident::Scene& scene) {
  write(arguments, out, report::comparison_text(result), report::comparison_json(result), report::comparison_csv(result),
        report::comparison_page(result, scene));
}

/// Writes the ways that were finished when the command was interrupted.
std::string save(const CompareArguments& arguments, std::ostream& out, std::optional<tasks::ComparisonResult> done,
                 const ident::Scene& scene) {
  if (!done) return "interrupted";
  done->comparison.interrupted = true;
  study::mark_fronts(done->comparison.combinations);
  write(arguments, out, *done, scene);
  return fmt::format("interrupted; the {} ways that were finished are written", done->comparison.combinations.size());
}

tasks::ComparisonResult compared(const CompareArguments& arguments, const ident::Scene& scene, std::ostream& out) {
  const auto lists = alternatives(arguments);
  SoFar<tasks::ComparisonResult> done;
  Progress progress;
  const auto keep = [&](const tasks::ComparisonResult& result) {
    if (!result.comparison.combinations.empty()) done.put(result);
  };
  return with_last_words([&] { return save(arguments, out, done.get(), scene); },
                         [&] { return tasks::compare_ways(scene, lists, watched(arguments, progress), keep); });
}

ExitCode compare_laws(const CompareArguments& arguments, const std::string& text, std::ostream& out) {
  refuse_alternatives(arguments);
  const laws::LawScene scene = laws::parse_law_scene(text, arguments.scene);
  check_outputs(arguments, laws::files_of(scene));
  Progress progress;
  const study::TrialOptions trials = watched(arguments, progress);
  const laws::LawComparison found = laws::compare_law_ways(scene, {.trials = trials.trials,
                                                                   .seed = trials.seed,
                                                                   .threads = threads_or_cores(trials.threads),
                                                                   .interrupted = trials.interrupted,
                                                                   .progress = trials.progress});
  write(arguments, out, report::law_comparison_text(scene, found), report::law_comparison_json(found),
        report::law_comparison_csv(found), report::law_comparison_page(scene, found));
  const bool answered = std::ranges::any_of(found.values, [](const auto& value) { return value.ways.front().answers > 0; });
  return answered ? ExitCode::done : ExitCode::unusable;
}

}  // namespace

void add_compare(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CompareArguments>(
      app, chosen, "compare", "Compare methods by error and run time, on the same trials with simulated noise");
  declare(*command, *arguments);
}

ExitCode execute(const CompareArguments& arguments, std::ostream& out) {
  check(arguments);
  if (arguments.reproduce == "list") {
    out << table_list();
    return ExitCode::done;
  }
  if (!arguments.reproduce.empty()) {
    check_outputs(arguments, {});
    const ReproductionReport report = reproduced(arguments);
    write(arguments, out, reproduction_text(report), reproduction_json(report), reproduction_csv(report),
          reproduction_report(report));
    return ExitCode::done;
  }
  const std::string text = scene::read_text(arguments.scene);
  if (scene::is_law_scene(text, arguments.scene)) return compare_laws(arguments, text, out);
  const ident::Scene scene = ident::parse_scene(text, arguments.scene);
  check_outputs(arguments, ident::files_of(scene));
  const tasks::ComparisonResult result = compared(arguments, scene, out);
  write(arguments, out, result, scene);
  return tasks::some_usable(result) ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
