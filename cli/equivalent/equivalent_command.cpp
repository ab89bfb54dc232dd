#include "cli/equivalent/equivalent_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/equivalent/equivalent_text.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/progress.hpp"

namespace jointid::cli {

void add_equivalent(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<EquivalentArguments>(
      app, chosen, "equivalent", "Find the stiffness and damping of a friction joint against its relative displacement");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] parts and [equivalent]")->required();
  add_outputs(command, *arguments, "stiffness and damping", "them (input of `loading-curve`)");
  command->footer(
      "Examples:\n  jointid problem write rig2 rig2 && jointid equivalent rig2/rig2.toml --csv joint.csv\n"
      "  jointid loading-curve joint.csv --stiffness stiffness --damping damping --law ren");
}

ExitCode execute(const EquivalentArguments& arguments, std::ostream& out) {
  const ident::EquivalentScene scene = ident::read_equivalent_scene(arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}, {"--csv", arguments.csv}});
  const std::vector<tasks::LevelJoint> levels =
      with_progress("reading and fitting", [&] { return tasks::find_equivalent(scene); });
  if (arguments.json) write_target(*arguments.json, equivalent_json(scene, levels), out);
  if (arguments.csv) write_target(*arguments.csv, equivalent_csv(levels), out);
  if (!takes_output({arguments.json, arguments.csv})) out << equivalent_text(scene, levels);
  if (all_settled(levels)) return ExitCode::done;
  print_error(arguments.scene.string() + ": no stiffness and damping fit the FRFs of some levels");
  return ExitCode::unusable;
}

}  // namespace jointid::cli
