#include "cli/pod/pod_command.hpp"

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/pod/pod_page.hpp"
#include "report/pod/pod_report.hpp"
#include "tasks/pod/run_pod.hpp"

namespace jointid::cli {

void add_pod(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<PodArguments>(app, chosen, "pod", "Find the proper orthogonal modes of time records of many channels");
  command
      ->add_option("FILES", arguments->files, "Samples: text, UFF 58, MATLAB, HDF5 or numpy; several files are further samples")
      ->required();
  command->add_option("--channels", arguments->channels, "Names or numbers of the columns (default: all but the time)")
      ->delimiter(',');
  command->add_option("--mass", arguments->mass, "File of the mass matrix of the channels, the inner product of the modes");
  command->add_option("--stiffness", arguments->stiffness,
                      "File of the stiffness matrix: cosines and MAC with the normal modes, with --mass");
  command->add_option("--compare", arguments->compare,
                      "File of modes, one column per mode, one row per channel: gives cosines and MAC");
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
  ident::start_together(*team, [&] {
    check_targets(files_of(arguments), {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
    check(arguments);
  });
  std::optional<tasks::PodResult> result;
  {
    Progress progress;
    constexpr std::size_t step = 100'000;
    ident::Control control;
    control.interrupted = interrupted;
    control.progress = [&, told = std::size_t{0}](const char*, std::size_t read, std::size_t) mutable {
      if (team->rank() > 0 || read / step == told) return;
      told = read / step;
      progress.show(std::to_string(read) + " samples read");
    };
    result = tasks::run_pod(arguments, *team, control);
  }
  if (!result) return ExitCode::done;
  const tasks::PodResult& found = *result;
  if (arguments.json) write_target(*arguments.json, report::pod_json(found), out);
  if (arguments.csv) write_target(*arguments.csv, report::pod_csv(found), out);
  if (arguments.report) write_target(*arguments.report, report::pod_page(found), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::pod_text(found);
  return ExitCode::done;
}

}  // namespace jointid::cli
