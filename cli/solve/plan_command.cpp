#include "cli/solve/plan_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/open_options.hpp"
#include "cli/options/output.hpp"
#include "report/result/bound_text.hpp"
#include "report/result/plan_text.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"

namespace jointid::cli {

PlanArguments& add_linear_plan(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<PlanArguments>(
      app, chosen, "plan", "Show what a solution of a scene reads, computes and leaves out, without solving");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  command->add_option("--json", arguments->json, "Write the plan as JSON to a file, or - for stdout");
  add_force(command);
  CLI::Option* bound = command->add_flag(
      "--bound", arguments->bound,
      "Predict standard errors and the effect of other data, from the FRFs of a model or an earlier test, the noise and "
      "[truth] or [identify] start");
  command
      ->add_option_function<std::vector<std::string>>(
          "--candidates",
          [arguments = arguments](const std::vector<std::string>& texts) {
            arguments->candidates = of_option("--candidates", [&] { return parse_dofs(texts); });
          },
          "Coordinates of the files that count as not measured, e.g. 3:+Y,4:+RZ; the output has the benefit of each")
      ->delimiter(',')
      ->needs(bound);
  command->footer(
      "Examples:\n  jointid plan joint.toml\n  jointid plan joint.toml --bound\n"
      "  jointid plan joint.toml --bound --candidates 3:+Y,4:+RZ");
  return *arguments;
}

namespace {

void write_plan(const PlanArguments& arguments, const ident::Plan& plan, const std::optional<tasks::BoundReport>& bound,
                std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, report::plan_json(plan, bound), out);
  if (arguments.json != "-") out << report::plan_text(plan) << (bound ? report::bound_text(*bound) : "");
}

constexpr const char* cut_short = "interrupted; what was predicted so far is written";

/// Interrupted, the plan and what was predicted so far are written, also when a step does not end in time.
tasks::BoundReport bound_of(const PlanArguments& arguments, const ident::Plan& plan, const ident::Control& control, std::ostream& out) {
  SoFar<tasks::BoundReport> kept;
  const auto save = [&]() -> std::string {
    tasks::BoundReport so_far = kept.get().value_or(tasks::BoundReport{});
    so_far.interrupted = true;
    write_plan(arguments, plan, so_far, out);
    return cut_short;
  };
  return with_last_words(save, [&] {
    return tasks::predict_bound(plan, arguments.candidates, control, [&](const tasks::BoundReport& report) { kept.put(report); });
  });
}

}  // namespace

bool is_elsewhere(const PlanArguments& arguments) { return arguments.run_laws == nullptr && needs_laws(arguments.scene); }

ExitCode execute(const PlanArguments& arguments, std::ostream& out) {
  const std::string text = scene::read_text(arguments.scene);
  if (is_law_or_line_scene(text, arguments.scene)) return run_law_scene(arguments, text, out);
  const ident::Scene scene = ident::parse_scene(text, arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}});
  const auto plan = with_progress("planning", [&] { return ident::make_plan(scene); });
  std::optional<tasks::BoundReport> bound;
  if (arguments.bound) {
    Progress progress;
    bound = bound_of(arguments, *plan, progress.control(), out);
    const std::string note = bound->interrupted ? "" : tasks::suspect_note(*plan, progress.control());
    if (!note.empty()) plan->notes.push_back(note);
  }
  const bool cut = bound && bound->interrupted;
  write_plan(arguments, *plan, bound, out);
  if (cut) throw Interrupted(cut_short);
  return ExitCode::done;
}

}  // namespace jointid::cli
