#include "cli/pod/pod_command.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/pod/pod_page.hpp"
#include "cli/pod/pod_report.hpp"
#include "cli/text/progress.hpp"
#include "dense/eigen.hpp"

namespace jointid::cli {
namespace {

std::vector<ident::NamedFile> files_of(const PodArguments& arguments) {
  std::vector<ident::NamedFile> files;
  for (const auto& file : arguments.files) files.push_back({file, "FILES"});
  for (const auto& [file, option] : {std::pair(arguments.mass, "--mass"), std::pair(arguments.stiffness, "--stiffness"),
                                     std::pair(arguments.compare, "--compare")}) {
    if (!file.empty()) files.push_back({file, option});
  }
  return files;
}

void check(const PodArguments& arguments) {
  check_targets(files_of(arguments), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const auto fail = [](const char* option, const char* problem, const char* remedy) {
    throw InputError({ErrorKind::usage, "", option, problem, remedy});
  };
  if (arguments.stiffness.empty()) return;
  if (arguments.mass.empty()) fail("--stiffness", "there is no mass matrix for the normal modes", "give --mass");
  if (!arguments.compare.empty()) fail("--stiffness", "there are other modes to compare with", "leave --compare out");
}

/// The modes that the report compares with: of a file, or normal modes of K and M.
Eigen::MatrixXd modes_to_compare(const PodArguments& arguments, const Eigen::MatrixXd& mass, PodReport& report) {
  if (!arguments.compare.empty()) {
    report.compared = "the modes of --compare";
    return read_pod_matrix(arguments.compare, report.names.size(), "--compare");
  }
  report.compared = "the normal modes of --stiffness and --mass";
  const Eigen::MatrixXd stiffness = read_pod_matrix(arguments.stiffness, report.names.size(), "--stiffness");
  if (stiffness.cols() != stiffness.rows() || !stiffness.isApprox(stiffness.transpose(), 1e-9))
    throw InputError(
        {ErrorKind::data, arguments.stiffness, "", "is not a symmetric matrix", "give the stiffness at the channels"});
  const dense::SymmetricEigen normal = dense::symmetric_eigen(stiffness, mass);
  for (const double square : normal.values)
    report.frequencies_hz.push_back(hertz(std::sqrt(std::max(square, 0.0))));
  return normal.vectors;
}

PodReport make_report(const PodArguments& arguments, PodRecord record) {
  series::PodOptions options;
  options.remove_mean = !arguments.keep_mean;
  if (!arguments.mass.empty()) options.mass = read_pod_matrix(arguments.mass, record.names.size(), "--mass");
  PodReport report{std::move(record.names),
                   std::move(record.units),
                   record.cut,
                   series::pod(record.triangle, options),
                   !arguments.mass.empty(),
                   arguments.keep_mean,
                   "",
                   {},
                   {},
                   {}};
  if (arguments.compare.empty() && arguments.stiffness.empty()) return report;
  const Eigen::MatrixXd modes = modes_to_compare(arguments, options.mass, report);
  report.cosines = series::mode_cosines(report.pod.modes, modes, options.mass);
  report.assurance = series::mode_assurance(report.pod.modes, modes);
  return report;
}

}  // namespace

void add_pod(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<PodArguments>(app, chosen, "pod", "Find the proper orthogonal modes of time records of many channels");
  command
      ->add_option("FILES", arguments->files, "Samples: text, UFF 58, MATLAB, HDF5 or numpy; several files are further samples")
      ->required();
  command->add_option("--channels", arguments->channels, "Names or numbers of the columns (default: all but the time)")
      ->delimiter(',');
  command->add_option("--mass", arguments->mass, "File of the mass matrix of the channels: modes in its inner product");
  command->add_option("--stiffness", arguments->stiffness,
                      "File of the stiffness matrix: cosines and MAC with the normal modes, with --mass");
  command->add_option("--compare", arguments->compare,
                      "File of modes, a column each, a row a channel: cosines and MAC with them");
  command->add_flag("--keep-mean", arguments->keep_mean, "Do not remove the mean");
  add_whole_number(command, "--threads", arguments->threads, "0 for all cores; the results do not depend on it",
                   counts_of_threads());
  add_outputs(command, *arguments, "values and modes", "modes", "values and modes");
  command->footer(
      "Examples:\n  jointid pod run.csv\n  jointid pod run1.csv run2.csv --channels 2,3,4 --mass m.csv --compare modes.csv "
      "--json pod.json\n  mpirun -n 4 jointid pod run.h5 --threads 1");
}

ExitCode execute(const PodArguments& arguments, std::ostream& out) {
  const auto team = ident::join_team();
  ident::start_together(*team, [&] { check(arguments); });
  std::optional<PodRecord> record;
  {
    Progress progress;
    constexpr std::size_t step = 100'000;
    record = read_pod_record(arguments, *team, [&, told = std::size_t{0}](std::size_t read) mutable {
      if (team->rank() > 0 || read / step == told) return;
      told = read / step;
      progress.show(std::to_string(read) + " samples read");
    });
  }
  if (team->rank() > 0) return ExitCode::done;
  const PodReport report = make_report(arguments, std::move(*record));
  if (arguments.json) write_target(*arguments.json, pod_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, pod_csv(report), out);
  if (arguments.report) write_target(*arguments.report, pod_report(report), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << pod_text(report);
  return ExitCode::done;
}

}  // namespace jointid::cli
