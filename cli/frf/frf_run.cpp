#include "cli/frf/frf_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"

namespace jointid::cli {
namespace {

/// The DOF of the force of file k, where the user says it.
void set_reference(const FrfArguments& arguments, std::size_t k, records::Record& record) {
  if (arguments.references.empty()) return;
  record.channels[records::force_channel(record)].dof = arguments.references[arguments.references.size() == 1 ? 0 : k];
}

/// What start times do to the FRFs, where they differ.
void note_delays(const records::Record& record, const std::string& file, FrfRun& run) {
  const auto late = std::ranges::max_element(record.channels, {}, [](const auto& channel) { return std::abs(channel.start_s); });
  if (late->start_s == 0.0) return;
  const std::string note =
      fmt::format("{}: {} {} begins {:g} s {} than {} {}; phases are those of the true times.", file, name(late->kind),
                  late->name, std::abs(late->start_s), late->start_s > 0.0 ? "later" : "earlier",
                  name(record.channels.front().kind), record.channels.front().name);
  if (std::ranges::find(run.delays, note) == run.delays.end()) run.delays.push_back(note);
}

}  // namespace

FrfRun run_frf(const FrfArguments& arguments) {
  const std::size_t files = arguments.files.size();
  if (arguments.references.size() > 1 && arguments.references.size() != files) {
    throw InputError({ErrorKind::usage,
                      {},
                      "--reference",
                      fmt::format("{} DOFs for {} files", arguments.references.size(), files),
                      "give one for all files, or one each"});
  }
  FrfRun run{{}, {}, 1, estimate_options(arguments), {}, {}};
  std::vector<records::Record> records;
  Progress progress;
  for (std::size_t k = 0; k < files; ++k) {
    progress.count("reading", k, files);
    for (records::Record& record : records::read_records(arguments.files[k], arguments.read)) {
      set_reference(arguments, k, record);
      note_delays(record, arguments.files[k].filename().string(), run);
      run.record_files.push_back(arguments.files[k].filename().string());
      run.rate_hz.push_back(record.rate_hz);
      records.push_back(std::move(record));
    }
    stop_if(interrupted);
  }
  progress.show("estimating");
  run.forces = records::force_channels(records.front()).size();
  run.made = records::make_frfs(records, run.options, interrupted);
  return run;
}

double begin_s(const FrfRun& run, const records::Blow& blow) {
  return static_cast<double>(blow.first) / run.rate_hz[blow.record];
}

std::vector<double> coherences(const FrfRun& run, std::size_t r, std::size_t c) {
  std::vector<double> out;
  const frf::FrfSet& set = run.made.set;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    const double value = run.made.coherence[set.index(line, r, c)];
    if (std::isfinite(value)) out.push_back(value);
  }
  return out;
}

}  // namespace jointid::cli
