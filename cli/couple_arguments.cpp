#include "cli/couple_arguments.hpp"

#include <CLI/CLI.hpp>
#include <memory>

namespace jointid::cli {

void add_couple(CLI::App& app, std::optional<Arguments>& chosen) {
  auto arguments = std::make_shared<CoupleArguments>();
  CLI::App* command = app.add_subcommand("couple", "Predict the FRFs of an assembly from those of its parts");
  command->callback([arguments, &chosen] { chosen = *arguments; });
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] parts and [couple]")->required();
  command->add_option("--out", arguments->out, "FRFs of the assembly (HDF5); default: SCENE's name with .coupled.h5, here");
  command->add_flag("--bounds", arguments->bounds,
                    "Leave out conditions that the others nearly imply, and write the FRFs with them as well: what is right lies between");
  command->add_option("--threads", arguments->threads, "0 for all cores; the results do not depend on it")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--json", arguments->json, "Write what was done as JSON to a file, or - for stdout");
  command->add_option("--csv", arguments->csv, "Write condition numbers and alphas line by line as CSV to a file, or - for stdout");
  command->footer(
      "Examples:\n  jointid problem write coupling-C c && jointid couple c/coupling-C.toml --bounds\n"
      "  jointid couple c/coupling-C.toml --out assembly.h5 --json -");
}

}  // namespace jointid::cli
