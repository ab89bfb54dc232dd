#include "cli/export/export_command.hpp"

#include <CLI/CLI.hpp>

#include "base/temporary_file.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/output.hpp"
#include "cli/text/progress.hpp"
#include "ident/scene/read_scene.hpp"
#include "report/export/export_files.hpp"
#include "tasks/export/exported_joint.hpp"

namespace jointid::cli {
namespace {

/// All that is read: a result, or a scene and its data.
std::vector<ident::NamedFile> inputs_of(const ExportArguments& arguments) {
  if (tasks::is_result_file(arguments.from)) return {{arguments.from, "the result"}};
  return ident::files_of(ident::read_scene(arguments.from));
}

report::ExportOptions options_of(const ExportArguments& arguments) {
  report::ExportOptions options;
  options.target = of_option("--to", [&] { return report::parse_export_target(arguments.to); });
  options.way = of_option("--as", [&] { return report::parse_export_way(arguments.as); });
  options.millimetres = of_option("--units", [&] { return find_word(arguments.units, {"SI", "mm"}, "system of units"); }) == 1;
  options.first_id = arguments.first_id;
  return options;
}

/// Files of one export begin alike.
std::filesystem::path stem_of(const ExportArguments& arguments) {
  std::filesystem::path stem = arguments.out.empty() ? arguments.from.filename() : arguments.out;
  if (arguments.out.empty()) return stem.replace_extension("joint");
  const bool has_ending = stem.extension() == ".bdf" || stem.extension() == ".inp" || stem.extension() == ".mtx";
  return has_ending ? stem.replace_extension() : stem;
}

}  // namespace

void add_export(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ExportArguments>(
      app, chosen, "export", "Write a joint for a finite-element program: Nastran, Ansys, Abaqus, Matrix Market");
  command->add_option("FROM", arguments->from, "Scene file (TOML), or the result of `jointid solve SCENE --json FILE`")
      ->required();
  command->add_option("--to", arguments->to, "nastran, ansys, abaqus or matrix-market")->required();
  command->add_option(
      "--as", arguments->as,
      "springs (CELAS2, COMBIN14, *SPRING), bush (CBUSH, *CONNECTOR) or matrix (DMIG, MATRIX27, *MATRIX INPUT); default: auto");
  command->add_option("--out", arguments->out, "Name of the files without their endings; default: FROM's name with .joint, here");
  command->add_option("--units", arguments->units, "Units of the cards: SI (default), or mm for N, mm, s, t");
  add_whole_number(command, "--band", arguments->band, "Which frequency band of the joint, from 1; 0: it has one", {});
  add_whole_number(command, "--first-id", arguments->first_id, "Number of the first element, property and type",
                   {.least = 1, .most = 99000000, .remedy = "numbers of elements have eight digits"});
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it",
                   counts_of_threads());
  add_force(command);
  command->footer(
      "Examples:\n  jointid export joint.toml --to nastran\n  jointid export result.json --to abaqus --as matrix --units mm "
      "--out bolt");
}

ExitCode execute(const ExportArguments& arguments, std::ostream& out) {
  const report::ExportOptions options = options_of(arguments);
  const std::vector<ident::NamedFile> inputs = inputs_of(arguments);
  const std::string stem = stem_of(arguments).string();
  std::vector<OptionTarget> targets;
  for (const std::string& suffix : report::export_suffixes(options)) targets.emplace_back("--out", stem + suffix);
  check_targets(inputs, targets);
  Progress progress;
  ident::Control control = progress.control();
  control.threads = arguments.threads;
  const tasks::ExportedJoint joint = tasks::exported_joint(arguments.from, arguments.band, control);
  for (const auto& [suffix, text] : report::export_files(joint, options)) {
    write_text(stem + suffix, text);
    out << "wrote " << stem + suffix << "\n";
  }
  return ExitCode::done;
}

}  // namespace jointid::cli
