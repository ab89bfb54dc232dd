#include "tasks/frf/run_frf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"

namespace jointid::tasks {
namespace {

/// The DOF of the force of file k, where the user says it.
void set_reference(const FrfTask& task, std::size_t k, records::Record& record) {
  if (task.references.empty()) return;
  record.channels[records::force_channel(record)].dof = task.references[task.references.size() == 1 ? 0 : k];
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

records::FrfOptions estimate_options(const FrfTask& task) {
  records::FrfOptions options = task.options;
  options.hammer.block_s = task.block_s;
  if (!task.shaker) return options;
  if (!task.block_s)
    throw InputError({ErrorKind::usage, {}, "--shaker", "states no length of the segments", "give --block SECONDS"});
  options.segments = task.segments;
  options.segments->block_s = *task.block_s;
  return options;
}

FrfRun run_frf(const FrfTask& task, const ident::Control& control) {
  const std::size_t files = task.files.size();
  if (files == 0) throw InputError({ErrorKind::usage, {}, "FILES", "there is none", "give files of time records"});
  if (task.references.size() > 1 && task.references.size() != files) {
    throw InputError({ErrorKind::usage,
                      {},
                      "--reference",
                      fmt::format("{} DOFs for {} files", task.references.size(), files),
                      "give one for all files, or one each"});
  }
  FrfRun run{{}, {}, 1, estimate_options(task), {}, {}};
  std::vector<records::Record> records;
  for (std::size_t k = 0; k < files; ++k) {
    if (control.progress) control.progress("reading", k, files);
    for (records::Record& record : records::read_records(task.files[k], task.read)) {
      set_reference(task, k, record);
      note_delays(record, task.files[k].filename().string(), run);
      run.record_files.push_back(task.files[k].filename().string());
      run.rate_hz.push_back(record.rate_hz);
      records.push_back(std::move(record));
    }
    stop_if(control.interrupted);
  }
  if (control.progress) control.progress("estimating", 0, 0);
  run.forces = records::force_channels(records.front()).size();
  run.made = records::make_frfs(records, run.options, control.interrupted);
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

}  // namespace jointid::tasks
