#include "cli/pod/pod_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/pod/pod_report.hpp"
#include "cli/text/progress.hpp"

namespace jointid::cli {
namespace {

std::vector<ident::NamedFile> files_of(const PodArguments& arguments) {
  std::vector<ident::NamedFile> files;
  for (const auto& file : arguments.files) files.push_back({file, "FILES"});
  if (!arguments.mass.empty()) files.push_back({arguments.mass, "--mass"});
  if (!arguments.compare.empty()) files.push_back({arguments.compare, "--compare"});
  return files;
}

PodReport make_report(const PodArguments& arguments) {
  PodRecord record = read_pod_record(arguments);
  series::PodOptions options;
  options.remove_mean = !arguments.keep_mean;
  if (!arguments.mass.empty()) options.mass = read_pod_matrix(arguments.mass, record.names.size(), "--mass");
  PodReport report{std::move(record.names), std::move(record.units), record.cut, series::pod(record.triangle, options),
                   !arguments.mass.empty(), arguments.keep_mean,     {},         {}};
  if (!arguments.compare.empty()) {
    const Eigen::MatrixXd modes = read_pod_matrix(arguments.compare, report.names.size(), "--compare");
    report.cosines = series::mode_cosines(report.pod.modes, modes, options.mass);
    report.assurance = series::mode_assurance(report.pod.modes, modes);
  }
  return report;
}

}  // namespace

void add_pod(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<PodArguments>(app, chosen, "pod", "Find the proper orthogonal modes of time records of many channels");
  command->add_option("FILES", arguments->files, "Columns of samples: text, MATLAB or HDF5; several files are further samples")
      ->required();
  command->add_option("--channels", arguments->channels, "Names or numbers of the columns (default: all but the time)")
      ->delimiter(',');
  command->add_option("--mass", arguments->mass, "File of the mass matrix of the channels: modes in its inner product");
  command->add_option("--compare", arguments->compare,
                      "File of modes, a column each, a row a channel: cosines and MAC with them");
  command->add_flag("--keep-mean", arguments->keep_mean, "Do not remove the mean");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it",
                   counts_of_threads());
  add_outputs(command, *arguments, "values and modes", "modes");
  command->footer(
      "Examples:\n  jointid pod run.csv\n  jointid pod run1.csv run2.csv --channels 2,3,4 --mass m.csv --compare modes.csv "
      "--json pod.json");
}

ExitCode execute(const PodArguments& arguments, std::ostream& out) {
  check_targets(files_of(arguments), {{"--json", arguments.json}, {"--csv", arguments.csv}});
  const PodReport report = with_progress("reading and decomposing", [&] { return make_report(arguments); });
  if (arguments.json) write_target(*arguments.json, pod_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, pod_csv(report), out);
  if (!takes_output({arguments.json, arguments.csv})) out << pod_text(report);
  return ExitCode::done;
}

}  // namespace jointid::cli
