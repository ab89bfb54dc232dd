#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report/solve_report.hpp"
#include "cli/solution_json.hpp"
#include "cli/solution_text.hpp"
#include "frf/error.hpp"
#include "frf/temporary_file.hpp"
#include "ident/solve.hpp"

namespace jointid::cli {
namespace {

/// Throws InputError (usage) when two results are to share standard output.
void check_targets(const SolveArguments& arguments) {
  if (arguments.json == "-" && arguments.csv == "-") {
    throw InputError({ErrorKind::usage, "", "--json - --csv -", "both want standard output", "give one of them a file"});
  }
}

ident::Solution solve_watched(ident::Plan& plan) {
  catch_interrupts();
  Progress progress;
  return ident::solve(plan, progress.control());
}

void write_report(const std::string& file, ident::Plan& plan, const ident::Solution& solution) {
  Progress progress;
  frf::write_text(file, report::solve_report(plan, solution, progress.control()));
}

}  // namespace

ExitCode execute(const SolveArguments& arguments, std::ostream& out) {
  check_targets(arguments);
  const ident::Scene scene = ident::read_scene(arguments.scene);
  const auto plan = ident::make_plan(scene);
  const ident::Solution solution = solve_watched(*plan);
  if (arguments.json) write_target(*arguments.json, solution_json(solution), out);
  if (arguments.csv) write_target(*arguments.csv, unknowns_csv(solution), out);
  if (arguments.json != "-" && arguments.csv != "-") out << solution_text(solution, scene.title);
  if (arguments.report) write_report(*arguments.report, *plan, solution);
  return solution.status == ident::Status::ok ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
