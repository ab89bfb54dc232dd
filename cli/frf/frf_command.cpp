#include "cli/frf/frf_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/progress.hpp"
#include "frf/file/write.hpp"
#include "report/frf/frf_page.hpp"
#include "report/frf/frf_text.hpp"

namespace jointid::cli {
namespace {

bool writes_hdf5(const std::filesystem::path& path) { return path.extension() == ".h5" || path.extension() == ".hdf5"; }

std::string written_text(const tasks::FrfRun& run, const std::filesystem::path& path) {
  const frf::FrfSet& set = run.made.set;
  std::string text = "wrote " + path.string() + ": " + frf::name(set.header.quantity);
  if (set.variance.empty()) return text + "\n";
  if (writes_hdf5(path)) return text + (set.has_covariance() ? " with variances and covariances\n" : " with variances\n");
  return text + (path.extension() == ".uff" || path.extension() == ".unv" ? ", without variances, for which UFF has no place\n"
                 : !set.has_covariance()                                  ? " with variances\n"
                                         : " with variances, without covariances, which HDF5 alone holds\n");
}

tasks::FrfRun made(const FrfArguments& arguments) {
  Progress progress;
  return tasks::run_frf(arguments, progress.control());
}

}  // namespace

void add_frf(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<FrfArguments>(app, chosen, "frf", "Estimate FRFs with coherences, variances and covariances from time records");
  declare(*command, *arguments);
}

ExitCode execute(const FrfArguments& arguments, std::ostream& out) {
  std::vector<ident::NamedFile> inputs;
  for (const auto& file : arguments.files) inputs.push_back({file, "FILES"});
  const Target output = arguments.output ? Target(arguments.output->string()) : std::nullopt;
  check_targets(inputs,
                {{"--output", output}, {"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const tasks::FrfRun run = made(arguments);
  if (arguments.output) with_progress("writing", [&] { frf::write(run.made.set, *arguments.output); });
  if (arguments.json) write_target(*arguments.json, report::frf_json(run, arguments.output), out);
  if (arguments.csv) write_target(*arguments.csv, report::stretches_csv(run), out);
  if (arguments.report) write_target(*arguments.report, report::frf_page(run), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) {
    out << report::frf_text(run);
    if (arguments.output) out << written_text(run, *arguments.output);
  }
  return ExitCode::done;
}

}  // namespace jointid::cli
