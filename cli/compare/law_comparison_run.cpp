#include "cli/compare/law_comparison_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/options/output.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "report/laws/law_comparison_text.hpp"

namespace jointid::cli {
namespace {

/// What is chosen in scenes of linear joints alone.
void refuse_alternatives(const CompareArguments& arguments) {
  const std::pair<const char*, bool> given[] = {
      {"--methods", !arguments.methods.empty()},       {"--equations", !arguments.equations.empty()},
      {"--weightings", !arguments.weightings.empty()}, {"--deltas", !arguments.deltas.empty()},
      {"--solvers", !arguments.solvers.empty()},       {"--regenerate", !arguments.regenerate.empty()}};
  const auto wrong = std::ranges::find_if(given, [](const auto& option) { return option.second; });
  if (wrong == std::end(given)) return;
  throw InputError({ErrorKind::usage, arguments.scene.string(), wrong->first,
                    "the scene is one of friction laws: its ways are the likelihood and two steps", "leave it out"});
}

}  // namespace

ExitCode compare_law_scene(const CompareArguments& arguments, const std::string& text, std::ostream& out) {
  refuse_alternatives(arguments);
  const laws::LawScene scene = laws::parse_law_scene(text, arguments.scene);
  check_targets(laws::files_of(scene), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  Progress progress;
  laws::LawStudyOptions options = {.trials = arguments.trials,
                                   .seed = arguments.seed,
                                   .threads = threads_or_cores(arguments.threads),
                                   .interrupted = interrupted};
  options.progress = [&](std::size_t done, std::size_t total) { progress.show(fmt::format("trial {} of {}", done, total)); };
  const laws::LawComparison found = laws::compare_law_ways(scene, options);
  if (arguments.json) write_target(*arguments.json, report::law_comparison_json(found), out);
  if (arguments.csv) write_target(*arguments.csv, report::law_comparison_csv(found), out);
  if (arguments.report) write_target(*arguments.report, report::law_comparison_page(scene, found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::law_comparison_text(scene, found);
  const bool answered = std::ranges::any_of(found.values, [](const auto& value) { return value.ways.front().answers > 0; });
  return answered ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
