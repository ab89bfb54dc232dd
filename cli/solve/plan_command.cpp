#include "cli/solve/plan_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/open_options.hpp"
#include "cli/options/output.hpp"
#include "cli/solve/bound_text.hpp"
#include "cli/solve/plan_text.hpp"
#include "cli/text/progress.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/scene/read_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "report/laws/law_bound_text.hpp"
#include "scene/text.hpp"

namespace jointid::cli {
namespace {

void note_suspect(ident::Plan& plan, const ident::Control& control) {
  const ident::CheckResult found = ident::quick_check(plan, control);
  if (found.verdict != ident::Verdict::clean) plan.notes.push_back(ident::phrase(found.suspects.front()));
}

ExitCode plan_laws(const laws::LawScene& scene, const PlanArguments& arguments, std::ostream& out) {
  const auto refuse = [&](const char* problem, const char* remedy) {
    throw InputError({ErrorKind::usage, arguments.scene.string(), "[[joint.friction]]", problem, remedy});
  };
  if (!arguments.bound) refuse("scenes of friction laws have no plan but the bound", "add --bound: what the levels will tell");
  if (!arguments.candidates.empty()) refuse("candidates of a friction scene are levels", "add [[data.levels]] without responses");
  check_targets(laws::files_of(scene), {{"--json", arguments.json}});
  const laws::LawBound bound = with_progress("predicting", [&] { return laws::predict_law_bound(scene); });
  if (arguments.json) write_target(*arguments.json, report::law_bound_json(scene, bound), out);
  if (arguments.json != "-") out << report::law_bound_text(scene, bound);
  return ExitCode::done;
}

}  // namespace

void add_plan(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<PlanArguments>(
      app, chosen, "plan", "Say what solving a scene reads, computes and leaves out, without doing it");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  command->add_option("--json", arguments->json, "Write the plan as JSON to a file, or - for stdout");
  CLI::Option* bound = command->add_flag("--bound", arguments->bound,
                                         "Predict standard errors from the FRFs of a model or an earlier test, the noise and "
                                         "[truth] or [identify] start, and what other data would change");
  command
      ->add_option_function<std::vector<std::string>>(
          "--candidates",
          [arguments = arguments](const std::vector<std::string>& texts) {
            arguments->candidates = of_option("--candidates", [&] { return parse_dofs(texts); });
          },
          "Coordinates of the files that are not measured yet, e.g. 3:+Y,4:+RZ: what would each of them bring?")
      ->delimiter(',')
      ->needs(bound);
  command->footer(
      "Examples:\n  jointid plan joint.toml\n  jointid plan joint.toml --bound\n"
      "  jointid plan joint.toml --bound --candidates 3:+Y,4:+RZ");
}

ExitCode execute(const PlanArguments& arguments, std::ostream& out) {
  const std::string text = scene::read_text(arguments.scene);
  if (laws::is_law_scene(text, arguments.scene)) return plan_laws(laws::parse_law_scene(text, arguments.scene), arguments, out);
  const ident::Scene scene = ident::parse_scene(text, arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}});
  const auto plan = with_progress("planning", [&] { return ident::make_plan(scene); });
  std::optional<tasks::BoundReport> bound;
  if (arguments.bound) {
    Progress progress;
    bound = tasks::predict_bound(*plan, arguments.candidates, progress.control());
    if (!bound->interrupted) note_suspect(*plan, progress.control());
  }
  const bool cut = bound && bound->interrupted;
  if (arguments.json) write_target(*arguments.json, plan_json(*plan, bound), out);
  if (arguments.json != "-") out << plan_text(*plan) << (bound ? bound_text(*bound) : "");
  if (cut) throw Interrupted("interrupted; what was predicted so far is written");
  return ExitCode::done;
}

}  // namespace jointid::cli
