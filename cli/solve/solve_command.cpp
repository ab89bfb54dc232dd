#include "cli/solve/solve_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/display_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/output.hpp"
#include "cli/solve/estimate_kept.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "report/page/limits.hpp"
#include "report/result/by_line.hpp"
#include "report/result/solution_text.hpp"
#include "report/result/solve_page.hpp"
#include "report/solution_json.hpp"
#include "report/text/display.hpp"
#include "report/text/frf_plot.hpp"
#include "scene/text.hpp"

namespace jointid::cli {
namespace {

constexpr const char* state_end = ".solve.partial";

void check_outputs(const SolveArguments& arguments, const ident::Scene& scene) {
  check_targets(ident::files_of(scene), {{"--json", arguments.json},
                                         {"--csv", arguments.csv},
                                         {"--report", arguments.report},
                                         {"--by-line", arguments.by_line},
                                         {"--by-iteration", arguments.by_iteration},
                                         {"--state", state_file(arguments.resume, arguments.scene, state_end).string()}});
}

report::Display display_of(const SolveArguments& arguments) { return cli::display_of(arguments.units, arguments.quantity); }

void write_numbers(const SolveArguments& arguments, const ident::Solution& solution, const std::string& title, std::ostream& out) {
  const report::Display display = display_of(arguments);
  const ident::Solution shown = report::in_units_of(display, solution);
  if (arguments.json) write_target(*arguments.json, report::solution_json(solution), out);
  if (arguments.csv) write_target(*arguments.csv, report::unknowns_csv(shown), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report}))
    out << report::solution_text(shown, title, report::units_text(display));
}

/// Writes the best estimate that there was when the command was interrupted, and marks it; the page would need the data again.
std::string save(const SolveArguments& arguments, std::optional<ident::Solution> best, const std::string& title, EstimateKept& kept,
                 std::ostream& out) {
  if (!best) return "interrupted";
  const std::string state = kept.words(*best);
  tasks::mark_interrupted(*best);
  write_numbers(arguments, *best, title, out);
  return "interrupted; the best values so far are written" + std::string(arguments.report ? ", the page is not" : "") + state;
}

/// All threads of this process: of all cores, its part of them where mpirun started several.
std::size_t own_threads(const SolveArguments& arguments, const ident::Team& team) {
  return team.size() == 1 ? arguments.threads : threads_or_cores(arguments.threads, team.size());
}

ident::Solution solve_watched(const SolveArguments& arguments, ident::Plan& plan, ident::Team& team, EstimateKept& kept,
                              tasks::IterationLog& log, std::ostream& out) {
  SoFar<ident::Solution> best;
  Progress progress;
  const bool leads = team.rank() == 0;
  ident::Control control = progress.control();
  if (!leads) control.progress = {};
  control.interrupted = is_over(arguments.resume);
  control.threads = own_threads(arguments, team);
  control.judgement = ident::Judgement::data;
  if (leads) {
    control.so_far = [&](const ident::Solution& solution) {
      best.put(solution);
      kept.put(solution);
      log.note(solution);
    };
  }
  if (team.size() > 1) control.shares = ident::LineShares(team);
  const auto work = [&] { return control.shares.together([&] { return ident::solve(plan, control); }); };
  if (!leads) return work();
  return with_last_words([&] { return save(arguments, best.get(), plan.scene.title, kept, out); }, work);
}

void write_report(const std::string& target, const ident::Plan& plan, const ident::Solution& solution,
                  const std::optional<tasks::FrfEntry>& entry, const tasks::IterationLog& log, const report::Display& display,
                  std::ostream& out) {
  Progress progress;
  tasks::SolutionDetails details =
      tasks::solution_details(plan, solution, {entry, report::most_frfs, report::worst_frfs_drawn}, progress.control());
  details.iterations = log.ended(solution);
  write_target(target, report::solve_report(plan, solution, details, display), out);
}

void write_by_line(const std::string& target, const ident::Plan& plan, std::ostream& out) {
  constexpr std::size_t most_points = 1000;
  const tasks::UnknownsByLine found = [&] {
    Progress progress;
    return tasks::unknowns_by_line(plan, most_points, progress.control());
  }();
  write_target(target, target.ends_with(".json") ? report::by_line_json(found) : report::by_line_csv(found), out);
}

void write_by_iteration(const std::string& target, ident::Plan& plan, std::ostream& out) {
  const tasks::UnknownsByIteration found = [&] {
    Progress progress;
    return tasks::unknowns_by_iteration(plan, progress.control());
  }();
  write_target(target, target.ends_with(".json") ? report::by_iteration_json(found) : report::by_iteration_csv(found), out);
}

/// The entry of --plot, RESPONSE/REFERENCE. Throws InputError (usage) when the assembly has no such FRF.
tasks::FrfEntry plotted_entry(const std::string& text, const ident::Plan& plan) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    throw InputError({ErrorKind::usage, "", "--plot", "'" + text + "' is not RESPONSE/REFERENCE", "write e.g. 1:+Y/5:+Y"});
  }
  const auto dof = [](const std::string& word) { return of_option("--plot", [&] { return frf::Dof::parse(word); }); };
  const tasks::FrfEntry entry{dof(text.substr(0, slash)), dof(text.substr(slash + 1))};
  if (!frf::has(plan.assembly->responses(), entry.response) ||
      !frf::has(plan.assembly->references(), entry.reference)) {
    throw InputError({ErrorKind::usage, "", "--plot", "the assembly has no FRF " + text,
                      "`jointid plan` lists the responses and references"});
  }
  return entry;
}

void plot(const tasks::FrfEntry& entry, const ident::Plan& plan, const ident::Solution& solution, const report::Display& display,
          std::ostream& out) {
  Progress progress;
  const tasks::Regenerated shown =
      report::in_units_of(display, tasks::regenerate(plan, solution.bands, {entry}, progress.control()));
  const std::string label = report::frf_label(display, entry.response, entry.reference);
  const std::size_t begin = label.find('(') + 1;
  out << report::frf_plot(shown, shown.frfs.front(), label.substr(begin, label.size() - 1 - begin));
}

/// With the quantity of the first file of the assembly where that is asked for.
report::Display display_of(const SolveArguments& arguments, const ident::Plan& plan) {
  report::Display display = display_of(arguments);
  if (arguments.quantity == "measured" && plan.assembly->source_count() > 0)
    display.quantity = plan.assembly->source(0).header().quantity;
  return display;
}

void refuse_display(const SolveArguments& arguments) {
  refuse_units(arguments.units);
  if (arguments.resume.keeps_from_start()) {
    throw InputError({ErrorKind::usage, "", "--resume", "does not apply to friction laws and joints at every line",
                      "leave --resume, --stop-before and --state out"});
  }
  if (arguments.by_line || arguments.by_iteration) {
    throw InputError({ErrorKind::usage, "", arguments.by_line ? "--by-line" : "--by-iteration",
                      "does not apply to friction laws and joints at every line",
                      "leave it out, or give a scene with [joint] of matrices"});
  }
  if (arguments.quantity == SolveArguments().quantity) return;
  throw InputError({ErrorKind::usage, "", "--quantity", "does not apply to friction laws and joints at every line",
                    "leave it out: their results are in SI units"});
}

}  // namespace

SolveArguments& add_linear_solve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<SolveArguments>(app, chosen, "solve", "Identify the joint of a scene");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  add_outputs(command, *arguments, "the solution", "the unknowns", "tables and plots");
  command->add_option("--plot", arguments->plot, "Plot an assembly FRF, measured and synthesised, e.g. 1:+Y/5:+Y");
  command->add_option("--by-line", arguments->by_line,
                      "Write each unknown over the accumulated lines and from each line alone to a file, CSV or .json; linear methods");
  command->add_option("--by-iteration", arguments->by_iteration,
                      "Write the objective and each unknown over the iterations to a file, CSV or .json; likelihood and newton");
  add_resume(command, arguments->resume, "the best values so far of an iterative method", state_end);
  add_units(command, arguments->units);
  add_quantity(command, arguments->quantity, "as the assembly's file");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it", counts_of_threads());
  command->footer(
      "Examples:\n  jointid solve joint.toml\n  jointid solve joint.toml --plot 1:+Y/5:+Y\n  jointid solve joint.toml --json - | "
      "jq .unknowns\n"
      "  jointid solve joint.toml --report joint.html\n  mpirun -n 4 jointid solve joint.toml");
  return *arguments;
}

bool is_elsewhere(const SolveArguments& arguments) { return arguments.run_laws == nullptr && needs_laws(arguments.scene); }

ExitCode execute(const SolveArguments& arguments, std::ostream& out) {
  const auto team = ident::join_team();
  std::string text;
  std::optional<ident::Scene> read;  // none: a scene of friction laws, or of the joint at every line
  std::optional<EstimateKept> kept;
  ident::start_together(*team, [&] {
    check(arguments.resume);
    text = scene::read_text(arguments.scene);
    if (is_law_or_line_scene(text, arguments.scene)) return;
    read = ident::parse_scene(text, arguments.scene);
    check_outputs(arguments, *read);
    const auto file = state_file(arguments.resume, arguments.scene, state_end);
    kept.emplace(KeptState(file, "solve", text, ident::files_of(*read)), *read, arguments.resume.keeps_from_start());
    if (arguments.resume.resume) kept->take_up(*read);
  });
  if (!read) {
    refuse_display(arguments);
    return team->rank() > 0 ? ExitCode::done : run_law_scene(arguments, text, out);
  }
  const ident::Scene& scene = *read;
  const auto plan = with_progress("planning", [&] { return ident::make_plan(scene, *team); });
  if (!kept->chosen().empty()) plan->chosen = kept->chosen();
  std::optional<tasks::FrfEntry> entry;
  ident::start_together(*team, [&] {
    if (arguments.plot) entry = plotted_entry(*arguments.plot, *plan);
    display_of(arguments);
  });
  tasks::IterationLog log;
  const ident::Solution solution = solve_watched(arguments, *plan, *team, *kept, log, out);
  if (team->rank() > 0) return ExitCode::done;
  write_numbers(arguments, solution, scene.title, out);
  const report::Display display = arguments.plot || arguments.report ? display_of(arguments, *plan) : report::Display();
  const bool has_text = !takes_output({arguments.json, arguments.csv, arguments.report});
  if (has_text && entry && !solution.bands.empty()) plot(*entry, *plan, solution, display, out);
  if (arguments.by_line) write_by_line(*arguments.by_line, *plan, out);
  if (arguments.by_iteration) write_by_iteration(*arguments.by_iteration, *plan, out);
  if (arguments.report) write_report(*arguments.report, *plan, solution, entry, log, display, out);
  kept->remove();
  return tell_status(arguments.scene.string(), solution.status, solution.message);
}

}  // namespace jointid::cli
