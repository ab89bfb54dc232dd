#include "cli/equivalent_arguments.hpp"

#include <CLI/CLI.hpp>

#include "cli/command_options.hpp"

namespace jointid::cli {

void add_equivalent(CLI::App& app, std::optional<Arguments>& chosen) {
  auto [command, arguments] = add_command<EquivalentArguments>(
      app, chosen, "equivalent", "Find the stiffness and damping of a friction joint against its relative displacement");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] parts and [equivalent]")->required();
  add_outputs(command, *arguments, "stiffness and damping", "them (input of `loading-curve`)");
  command->footer(
      "Examples:\n  jointid problem write rig2 rig2 && jointid equivalent rig2/rig2.toml --csv joint.csv\n"
      "  jointid loading-curve joint.csv --stiffness stiffness --damping damping --law ren");
}

}  // namespace jointid::cli
