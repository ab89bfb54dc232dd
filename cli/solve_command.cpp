#include "cli/commands.hpp"
#include "cli/failure.hpp"
#include "cli/frf_plot.hpp"
#include "cli/interrupt.hpp"
#include "cli/of_option.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report/solve_report.hpp"
#include "cli/solution_json.hpp"
#include "cli/solution_text.hpp"
#include "frf/error.hpp"
#include "ident/solve.hpp"

namespace jointid::cli {
namespace {

ident::Solution solve_watched(ident::Plan& plan) {
  catch_interrupts();
  Progress progress;
  return ident::solve(plan, progress.control());
}

void write_report(const std::string& target, ident::Plan& plan, const ident::Solution& solution,
                  const std::optional<ident::FrfEntry>& entry, std::ostream& out) {
  Progress progress;
  write_target(target, report::solve_report(plan, solution, entry, progress.control()), out);
}

/// The entry of --plot, RESPONSE/REFERENCE. Throws InputError (usage) when the assembly has no such FRF.
ident::FrfEntry plotted_entry(const std::string& text, const ident::Plan& plan) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    throw InputError({ErrorKind::usage, "", "--plot", "'" + text + "' is not RESPONSE/REFERENCE", "write e.g. 1:+Y/5:+Y"});
  }
  const auto dof = [](const std::string& word) { return of_option("--plot", [&] { return frf::Dof::parse(word); }); };
  const ident::FrfEntry entry{dof(text.substr(0, slash)), dof(text.substr(slash + 1))};
  if (frf::find_coordinate(plan.assembly->responses(), entry.response) == frf::npos ||
      frf::find_coordinate(plan.assembly->references(), entry.reference) == frf::npos) {
    throw InputError({ErrorKind::usage, "", "--plot", "the assembly has no FRF " + text,
                      "`jointid plan` lists the responses and references"});
  }
  return entry;
}

void plot(const ident::FrfEntry& entry, ident::Plan& plan, const ident::Solution& solution, std::ostream& out) {
  Progress progress;
  const ident::Regenerated regenerated = ident::regenerate(plan, solution.bands, {entry}, progress.control());
  out << frf_plot(regenerated, regenerated.frfs.front());
}

}  // namespace

ExitCode execute(const SolveArguments& arguments, std::ostream& out) {
  check_targets(arguments.scene,
                {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const ident::Scene scene = ident::read_scene(arguments.scene);
  const auto plan = ident::make_plan(scene);
  std::optional<ident::FrfEntry> entry;
  if (arguments.plot) entry = plotted_entry(*arguments.plot, *plan);
  const ident::Solution solution = solve_watched(*plan);
  if (arguments.json) write_target(*arguments.json, solution_json(solution), out);
  if (arguments.csv) write_target(*arguments.csv, unknowns_csv(solution), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) {
    out << solution_text(solution, scene.title);
    if (entry && !solution.bands.empty()) plot(*entry, *plan, solution, out);
  }
  if (arguments.report) write_report(*arguments.report, *plan, solution, entry, out);
  if (solution.status == ident::Status::ok) return ExitCode::done;
  print_error(arguments.scene.string() + ": " + solution.message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
