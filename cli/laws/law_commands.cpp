#include "cli/laws/law_commands.hpp"

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/check/check_command.hpp"
#include "cli/options/output.hpp"
#include "cli/solve/plan_command.hpp"
#include "cli/solve/solve_command.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "ident/scene/scene_files.hpp"
#include "impedance/check_lines.hpp"
#include "impedance/identify_lines.hpp"
#include "impedance/line_plan.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "laws/task/law_bound.hpp"
#include "report/impedance/line_plan_text.hpp"
#include "report/impedance/line_report.hpp"
#include "report/laws/law_bound_text.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_text.hpp"
#include "scene/kind.hpp"

namespace jointid::cli {
namespace {

/// There are no FRFs of an assembly to plot.
ExitCode solve_lines(const SolveArguments& arguments, const std::string& text, std::ostream& out) {
  if (arguments.plot) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "--plot", "Z at every line synthesises no FRF of the assembly",
                      "leave --plot out; --report shows Z"});
  }
  const impedance::LineScene scene = impedance::parse_line_scene(text, arguments.scene);
  check_targets(ident::files_of(scene.scene), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  Progress progress;
  ident::Control control = progress.control();
  control.threads = arguments.threads;
  const impedance::IdentifiedLines found = impedance::identify_lines(scene, control);
  if (arguments.json) write_target(*arguments.json, report::line_json(scene, found), out);
  if (arguments.csv) write_target(*arguments.csv, report::line_csv(found), out);
  if (arguments.report) write_target(*arguments.report, report::line_page(scene, found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::line_text(scene, found);
  return tell_status(scene.scene.file.string(), found.status, found.message);
}

ExitCode solve_laws(const SolveArguments& arguments, const std::string& text, std::ostream& out) {
  if (scene::is_line_scene(text, arguments.scene)) return solve_lines(arguments, text, out);
  if (arguments.plot) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "--plot",
                      "the scene is one of friction laws: there is no FRF of an assembly", "leave --plot out"});
  }
  const laws::LawScene scene = laws::parse_law_scene(text, arguments.scene);
  check_targets(laws::files_of(scene), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const response::FitWork work = {.threads = threads_or_cores(arguments.threads), .interrupted = interrupted};
  const laws::LawIdentification found = with_progress("fitting friction laws", [&] { return laws::identify_laws(scene, work); });
  if (arguments.json) write_target(*arguments.json, report::law_json(scene, found), out);
  if (arguments.csv) write_target(*arguments.csv, report::law_csv(scene, found), out);
  if (arguments.report) write_target(*arguments.report, report::law_page(scene, found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::law_text(scene, found);
  return tell_status(scene.file.string(), found.status, found.message);
}

ExitCode plan_lines(const PlanArguments& arguments, const std::string& text, std::ostream& out) {
  if (!arguments.candidates.empty()) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "--candidates",
                      "what further coordinates bring Z at every line is not predicted",
                      "compare `plan --bound` of two scenes, with and without them"});
  }
  const impedance::LineScene scene = impedance::parse_line_scene(text, arguments.scene);
  check_targets(ident::files_of(scene.scene), {{"--json", arguments.json}});
  Progress progress;
  const impedance::LinePlan plan = impedance::plan_lines(scene, arguments.bound, progress.control());
  if (arguments.json) write_target(*arguments.json, report::line_plan_json(scene, plan), out);
  if (arguments.json != "-") out << report::line_plan_text(scene, plan);
  return ExitCode::done;
}

ExitCode plan_laws(const PlanArguments& arguments, const std::string& text, std::ostream& out) {
  if (scene::is_line_scene(text, arguments.scene)) return plan_lines(arguments, text, out);
  const auto refuse = [&](const char* problem, const char* remedy) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "[[joint.friction]]", problem, remedy});
  };
  const laws::LawScene scene = laws::parse_law_scene(text, arguments.scene);
  if (!arguments.bound) {
    refuse("scenes of friction laws have no plan but the bound", "add --bound: it predicts the standard errors of the force levels");
  }
  if (!arguments.candidates.empty()) refuse("candidates of a friction scene are force levels", "add [[data.levels]] without responses");
  check_targets(laws::files_of(scene), {{"--json", arguments.json}});
  const laws::LawBound bound = with_progress("predicting", [&] { return laws::predict_law_bound(scene); });
  if (arguments.json) write_target(*arguments.json, report::law_bound_json(scene, bound), out);
  if (arguments.json != "-") out << report::law_bound_text(scene, bound);
  return ExitCode::done;
}

ExitCode check_lines(const CheckArguments& arguments, const std::string& text, std::ostream& out) {
  if (!scene::is_line_scene(text, arguments.scene)) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "[[joint.friction]]",
                      "scenes of friction laws have no check of their own",
                      "run `jointid solve`: it states which levels and harmonics no law explains"});
  }
  const impedance::LineScene scene = impedance::parse_line_scene(text, arguments.scene);
  check_targets(ident::files_of(scene.scene), {{"--json", arguments.json}});
  Progress progress;
  write_check(arguments, impedance::check_lines(scene, progress.control()), out);
  return ExitCode::done;
}

}  // namespace

void add_solve(CLI::App& app, Chosen& chosen) { add_linear_solve(app, chosen).run_laws = solve_laws; }

void add_plan(CLI::App& app, Chosen& chosen) { add_linear_plan(app, chosen).run_laws = plan_laws; }

void add_check(CLI::App& app, Chosen& chosen) { add_linear_check(app, chosen).run_laws = check_lines; }

}  // namespace jointid::cli
