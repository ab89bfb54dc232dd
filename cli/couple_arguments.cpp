#include "cli/couple_arguments.hpp"

#include <CLI/CLI.hpp>

#include "cli/command_options.hpp"
#include "cli/whole_number.hpp"

namespace jointid::cli {

void add_couple(CLI::App& app, std::optional<Arguments>& chosen) {
  auto [command, arguments] =
      add_command<CoupleArguments>(app, chosen, "couple", "Predict the FRFs of an assembly from those of its parts");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] parts and [couple]")->required();
  command->add_option("--out", arguments->out, "FRFs of the assembly (HDF5); default: SCENE's name with .coupled.h5, here");
  command->add_flag("--bounds", arguments->bounds,
                    "Leave out conditions that the others nearly imply, and write the FRFs with them as well: what is right lies between");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it", counts_of_threads());
  add_outputs(command, *arguments, "what was done", "condition numbers, alphas and singular values line by line",
              "predicted FRFs, conditions and thresholds");
  command->footer(
      "Examples:\n  jointid problem write coupling-C c && jointid couple c/coupling-C.toml --bounds\n"
      "  jointid couple c/coupling-C.toml --bounds --report c.html\n"
      "  jointid couple c/coupling-C.toml --out assembly.h5 --json -");
}

}  // namespace jointid::cli
