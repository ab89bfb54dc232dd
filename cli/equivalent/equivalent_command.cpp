#include "cli/equivalent/equivalent_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/display_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "report/equivalent/equivalent_page.hpp"
#include "report/equivalent/equivalent_text.hpp"
#include "report/laws/direct_page.hpp"
#include "report/laws/direct_text.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"

namespace jointid::cli {

namespace {

std::vector<std::pair<std::string, Target>> outputs_of(const EquivalentArguments& arguments) {
  return {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}};
}

/// Without a law, of levels of force.
ExitCode take_direct_steps(const EquivalentArguments& arguments, const laws::LawScene& scene, std::ostream& out) {
  check_targets(laws::files_of(scene), outputs_of(arguments));
  const laws::DirectIdentification found = with_progress("reading", [&] { return laws::identify_directly(scene); });
  if (arguments.json) write_target(*arguments.json, report::direct_json(scene, found), out);
  if (arguments.csv) write_target(*arguments.csv, report::direct_csv(scene, found), out);
  if (arguments.report) write_target(*arguments.report, report::direct_page(scene, found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::direct_text(scene, found);
  return tell_status(scene.file.string(), found.status, found.message);
}

std::vector<tasks::LevelJoint> joints_of(const ident::EquivalentScene& scene) {
  Progress progress;
  return tasks::find_equivalent(scene, progress.control());
}

}  // namespace

void add_equivalent(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<EquivalentArguments>(
      app, chosen, "equivalent", "Find the stiffness and damping of a friction joint over its relative displacement");
  command
      ->add_option("SCENE", arguments->scene,
                   "Scene file (TOML) with [data] parts and [equivalent], or [[data.levels]] and [[joint.friction]]")
      ->required();
  add_outputs(command, *arguments, "stiffness and damping", "them (input of `loading-curve`)",
              "plots over displacement, and measured loops");
  add_units(command, arguments->units);
  command->footer(
      "Examples:\n  jointid problem write rig2 rig2 && jointid equivalent rig2/rig2.toml --csv joint.csv\n"
      "  jointid loading-curve joint.csv --stiffness stiffness --damping damping --law ren\n"
      "  jointid problem write sdof-iwan iwan && jointid equivalent iwan/sdof-iwan.toml --report equivalent.html");
}

ExitCode execute(const EquivalentArguments& arguments, std::ostream& out) {
  const report::Display display = display_of(arguments.units);
  const std::string text = scene::read_text(arguments.scene);
  if (scene::is_law_scene(text, arguments.scene)) {
    refuse_units(arguments.units);
    return take_direct_steps(arguments, laws::parse_law_scene(text, arguments.scene), out);
  }
  const ident::EquivalentScene scene = ident::parse_equivalent_scene(text, arguments.scene);
  check_targets(ident::files_of(scene), outputs_of(arguments));
  const std::vector<tasks::LevelJoint> levels = joints_of(scene);
  if (arguments.json) write_target(*arguments.json, report::equivalent_json(scene, levels), out);
  if (arguments.csv) write_target(*arguments.csv, report::equivalent_csv(levels, display), out);
  if (arguments.report) write_target(*arguments.report, report::equivalent_page(scene, levels, display), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::equivalent_text(scene, levels, display);
  if (tasks::all_settled(levels)) return ExitCode::done;
  print_error(arguments.scene.string() + ": no stiffness and damping fit the FRFs of some levels");
  return ExitCode::unusable;
}

}  // namespace jointid::cli
