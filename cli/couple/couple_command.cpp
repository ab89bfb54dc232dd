#include "cli/couple/couple_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/display_options.hpp"
#include "cli/options/output.hpp"
#include "cli/options/whole_number.hpp"
#include "cli/text/progress.hpp"
#include "cli/text/tell_status.hpp"
#include "frf/file/file_format.hpp"
#include "models/model_file.hpp"
#include "report/couple/couple_page.hpp"
#include "report/couple/couple_text.hpp"
#include "report/page/limits.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path result_path(const CoupleArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::filesystem::path path = arguments.scene.filename();
  path.replace_extension(".coupled.h5");
  return path;
}

void check_outputs(const CoupleArguments& arguments, const ident::CoupleScene& scene, const std::filesystem::path& out) {
  std::vector<OptionTarget> targets = {
      {"--out", out.string()}, {"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}};
  if (arguments.bounds) targets.push_back({"--bounds", tasks::with_all_path(out).string()});
  check_targets(ident::files_of(scene), targets);
}

/// With the quantity of the first part that is a file of FRFs where that is asked for.
report::Display display_of(const CoupleArguments& arguments, const ident::CoupleScene& scene) {
  report::Display display = cli::display_of(arguments.units, arguments.quantity);
  if (arguments.quantity != "measured") return display;
  for (const ident::DataFile& part : scene.parts) {
    if (models::is_model_file(part.path)) continue;
    display.quantity = frf::open(part.path, part.options)->header().quantity;
    break;
  }
  return display;
}

std::string page_of(const CoupleArguments& arguments, const ident::CoupleScene& scene, const tasks::CoupleResult& result) {
  std::vector<tasks::PredictedFrf> predicted;
  if (!result.records.empty()) predicted = tasks::read_predicted(result, report::most_frfs);
  return report::couple_page(scene, result, predicted, display_of(arguments, scene));
}

}  // namespace

void add_couple(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CoupleArguments>(
      app, chosen, "couple", "Couple substructures (LM-FBS): FRFs of the assembly from those of its parts; or decouple one");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] parts and [couple]")->required();
  command->add_option("--out", arguments->out, "FRFs of the assembly (HDF5); default: SCENE's name with .coupled.h5, here");
  command->add_flag(
      "--bounds", arguments->bounds,
      "Leave out nearly redundant pairs, and write a second file of FRFs with all pairs. The true FRFs lie between the two");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it",
                   counts_of_threads());
  add_outputs(command, *arguments, "what was done", "condition numbers, alphas and singular values line by line",
              "predicted FRFs, conditions and thresholds");
  add_units(command, arguments->units);
  add_quantity(command, arguments->quantity, "as the file of the first part");
  command->footer(
      "Examples:\n  jointid problem write coupling-C c && jointid couple c/coupling-C.toml --bounds\n"
      "  jointid couple c/coupling-C.toml --bounds --report c.html\n"
      "  jointid couple c/coupling-C.toml --out assembly.h5 --json -");
}

ExitCode execute(const CoupleArguments& arguments, std::ostream& out) {
  const std::filesystem::path path = result_path(arguments);
  const ident::CoupleScene scene = ident::read_couple_scene(arguments.scene);
  check_outputs(arguments, scene, path);
  display_of(arguments.units, arguments.quantity);
  Progress progress;
  ident::Control control = progress.control();
  control.threads = arguments.threads;
  const tasks::CoupleResult result = tasks::couple(scene, path, arguments.bounds, control);
  if (arguments.json) write_target(*arguments.json, report::couple_json(scene, result), out);
  if (arguments.csv) write_target(*arguments.csv, report::couple_csv(result), out);
  if (arguments.report) write_target(*arguments.report, page_of(arguments, scene, result), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::couple_text(scene, result);
  return tell_status(arguments.scene.string(), result.status, result.message);
}

}  // namespace jointid::cli
