#include "cli/correlate/correlate_command.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "frf/file/write.hpp"
#include "report/correlation/correlation_report.hpp"
#include "tasks/correlate/compared_files.hpp"

namespace jointid::cli {
namespace {

/// What was asked for alone; `json`: makes that text.
template <class Found, class Json>
void write_results(const CorrelateArguments& arguments, const report::ComparedFiles& files, const Found& found, const Json& json,
                   std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, json(), out);
  if (arguments.csv) write_target(*arguments.csv, report::correlation_csv(found), out);
  if (!takes_output({arguments.json, arguments.csv})) out << report::correlation_text(files, found);
}

/// With the files that descriptions of models name.
std::vector<ident::NamedFile> inputs(const std::vector<ident::NamedFile>& files) {
  std::vector<ident::NamedFile> all;
  for (const ident::NamedFile& file : files) {
    for (ident::NamedFile& each : tasks::compared_inputs(file.path, file.place)) all.push_back(std::move(each));
  }
  return all;
}

std::filesystem::path expanded_path(const ExpandArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::filesystem::path path = arguments.measured.filename();
  path.replace_extension(".expanded.h5");
  return path;
}

}  // namespace

void add_correlate(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CorrelateArguments>(
      app, chosen, "correlate", "Compare FRFs or mode shapes of two files: FRAC, LAC, FDAC, MAC, CoMAC beside χ²/f");
  command->add_option("ONE", arguments->one, "FRFs of a structure (UFF, HDF5, MAT, numpy, CSV, text), or its modes with --modes")
      ->required();
  command
      ->add_option("OTHER", arguments->other,
                   "The same structure, measured again or by a model; the description of one (*.toml), too")
      ->required();
  CLI::Option* modes = command->add_flag("--modes", arguments->modes,
                                         "Compare mode shapes (universal files with dataset 55, or JSON of modalfit)");
  command->add_option("--fdac", arguments->fdac, "A reference, e.g. 1:+Z: its FDAC, line by line, in the JSON")->excludes(modes);
  add_outputs(command, *arguments, "all criteria", "one FRF or mode a row");
  command->footer(
      "Examples:\n  jointid correlate measured.uff model.h5\n  jointid correlate measured.uff bracket.toml\n"
      "  jointid correlate test_modes.uff fe_modes.uff --modes --json -");
}

ExitCode execute(const CorrelateArguments& arguments, std::ostream& out) {
  check_targets(inputs({{arguments.one, "ONE"}, {arguments.other, "OTHER"}}),
                {{"--json", arguments.json}, {"--csv", arguments.csv}});
  report::ComparedFiles files{arguments.one.string(), arguments.other.string()};
  if (arguments.modes) {
    const correlation::CorrelatedModes found =
        correlation::correlate(tasks::read_modes(arguments.one), tasks::read_modes(arguments.other));
    write_results(
        arguments, files, found, [&] { return report::correlation_json(files, found); }, out);
    return ExitCode::done;
  }
  const auto [one, other, notes] = tasks::read_compared(arguments.one, arguments.other);
  files.notes = notes;
  const correlation::CorrelatedFrfs found = correlation::correlate(one, other);
  std::optional<correlation::ShapesOverLines> shapes;
  if (!arguments.fdac.empty()) shapes = correlation::shapes_over_lines(one, other, frf::Dof::parse(arguments.fdac));
  write_results(
      arguments, files, found, [&] { return report::correlation_json(files, found, shapes ? &*shapes : nullptr); }, out);
  return ExitCode::done;
}

void add_expand(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ExpandArguments>(
      app, chosen, "expand", "FRFs at coordinates that were not measured, by a parent model: SEMM, or SEREP by its modes");
  command
      ->add_option(
          "PARENT", arguments->parent,
          "FRFs of the model between all its coordinates, or its description (*.toml); for way serep its modes (universal file, "
          "dataset 55)")
      ->required();
  command->add_option("MEASURED", arguments->measured, "FRFs that were measured at some of them")->required();
  command->add_option("--way", arguments->way, "extended or semm (system equivalent model mixing), or serep")
      ->check(CLI::IsMember({"extended", "semm", "serep"}));
  add_whole_number(command, "--modes", arguments->modes, "Modes that serep keeps, the first so many; 0 for all", {});
  command->add_option("--out", arguments->out, "FRFs (HDF5, UFF, MAT or CSV); default: MEASURED's name with .expanded.h5, here");
  command->add_option("--json", arguments->json, "Write what was done as JSON to a file, or - for stdout");
  add_force(command);
  command->footer(
      "Examples:\n  jointid expand model.h5 measured.uff\n  jointid expand modes.uff measured.uff --way serep --modes 6 --out "
      "all.h5");
}

ExitCode execute(const ExpandArguments& arguments, std::ostream& out) {
  const std::filesystem::path path = expanded_path(arguments);
  check_targets(inputs({{arguments.parent, "PARENT"}, {arguments.measured, "MEASURED"}}),
                {{"--out", path.string()}, {"--json", arguments.json}});
  if (arguments.modes > 0 && arguments.way != "serep")
    throw InputError({.kind = ErrorKind::usage,
                      .file = "",
                      .place = "--modes",
                      .problem = "way " + arguments.way + " has FRFs for a parent, no modes",
                      .remedy = "add --way serep, or leave --modes out"});
  const auto [found, notes] = tasks::expanded_files(arguments.parent, arguments.measured, arguments.way, arguments.modes);
  frf::write(found.set, path);
  const report::ExpansionNames names{arguments.parent.string(), arguments.measured.string(), arguments.way, path.string(), notes};
  if (arguments.json) write_target(*arguments.json, report::expansion_json(names, found), out);
  if (!takes_output({arguments.json})) out << report::expansion_text(names, found);
  return ExitCode::done;
}

}  // namespace jointid::cli
