#include "cli/decouple/decouple_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "frf/file/write.hpp"
#include "ident/scene/scene_files.hpp"
#include "impedance/decouple/decouple.hpp"
#include "report/impedance/decouple_report.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path decoupled_path(const DecoupleArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::filesystem::path path = arguments.scene.filename();
  path.replace_extension(".decoupled.h5");
  return path;
}

}  // namespace

void add_decouple(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<DecoupleArguments>(
      app, chosen, "decouple", "Decouple a substructure: FRFs of B with variances from those of AB and A");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] assembly (AB), substructures (A) and [decouple]")
      ->required();
  command->add_option("--out", arguments->out,
                      "FRFs of B (HDF5, UFF, MAT or CSV); default: SCENE's name with .decoupled.h5, here");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it",
                   counts_of_threads());
  add_outputs(command, *arguments, "FRFs and the dynamic stiffness of B with their variances", "FRFs of B");
  command->footer("Examples:\n  jointid decouple fixture.toml\n  jointid decouple fixture.toml --out B.h5 --json -");
}

ExitCode execute(const DecoupleArguments& arguments, std::ostream& out) {
  const std::filesystem::path path = decoupled_path(arguments);
  const impedance::DecoupleScene scene = impedance::read_decouple_scene(arguments.scene);
  check_targets(ident::files_of(scene.lines.scene),
                {{"--out", path.string()}, {"--json", arguments.json}, {"--csv", arguments.csv}});
  Progress progress;
  ident::Control control = progress.control();
  control.threads = arguments.threads;
  const impedance::Decoupled found = impedance::decouple(scene, control);
  frf::write(impedance::frfs_of(found, found.ways.front()), path);
  if (arguments.json) write_target(*arguments.json, report::decouple_json(scene, found, path.string()), out);
  if (arguments.csv) write_target(*arguments.csv, report::decouple_csv(found), out);
  if (!takes_output({arguments.json, arguments.csv})) out << report::decouple_text(scene, found, path.string());
  return tell_status(arguments.scene.string(), found.status, found.message);
}

}  // namespace jointid::cli
