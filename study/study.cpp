#include "study/study.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "study/outbox.hpp"
#include "study/study_records.hpp"
#include "study/study_workers.hpp"

namespace jointid::study {
namespace {

std::string hash_of(const TrialData& data) {
  std::uint64_t sum = frf::checksum({});
  for (const auto* sets : {&data.base.substructures, &data.base.assembly}) {
    for (const frf::FrfSet& set : *sets) {
      sum = frf::checksum(std::as_bytes(std::span(set.header.frequency_hz)), sum);
      sum = frf::checksum(std::as_bytes(std::span(set.values)), sum);
      sum = frf::checksum(std::as_bytes(std::span(set.coherence)), sum);
    }
  }
  return std::to_string(sum);
}

bool has_intervals(const std::shared_ptr<const TrialData>& data, std::uint64_t seed) {
  const Trial first = TrialRunner(data).run(seed, 0);
  return std::any_of(first.ci95.begin(), first.ci95.end(), [](const auto& interval) { return interval.has_value(); });
}

class Study {
 public:
  Study(const std::shared_ptr<const TrialData>& data, const StudyOptions& options, ident::Team& team, const StudyControl& control)
      : data_(data), options_(options), team_(team), control_(control) {}

  StudyRun lead() {
    std::optional<StudyRecords> opened;
    std::vector<frf::IndexRange> missing;
    start_together(team_, [&] {
      choose_columns();
      opened.emplace(options_, header());
      missing = opened->missing();
    });
    StudyRecords& records = *opened;
    StudyRun run;
    run.done = options_.trials - count(missing);
    share(missing);
    supervise(records, missing, run);
    run.complete = run.done == options_.trials;
    if (run.complete) records.finish();
    return run;
  }

  StudyRun follow() {
    start_together(team_, [&] { choose_columns(); });
    std::vector<frf::IndexRange> missing;
    share(missing);
    Outbox outbox;
    StudyRun run;
    {
      TrialQueue queue(part_of(missing, team_.rank(), team_.size()));
      StudyWorkers workers(data_, columns_, options_.seed, threads(), queue,
                           [&](std::size_t trial, std::span<const double> row) { outbox.put(trial, row); }, state_);
      for (bool ended = false; !ended;) {
        ended = workers.wait_ms(5);
        const std::vector<double> numbers = outbox.take();
        if (!numbers.empty()) team_.send(numbers);
        if (team_.stopped() || is_interrupted()) state_.stop = true;
      }
    }
    team_.send_end(ident::text_of_end(state_.failure));
    run.done = run.computed = state_.computed;
    return run;
  }

 private:
  std::size_t threads() const { return threads_or_cores(options_.threads); }
  bool is_interrupted() const { return control_.interrupted && control_.interrupted(); }

  void choose_columns() { columns_ = columns_of(*data_, has_intervals(data_, options_.seed)); }

  frf::TableHeader header() const {
    frf::TableHeader header = header_of(*data_, columns_);
    header.texts.insert(options_.texts.begin(), options_.texts.end());
    header.texts["seed"] = std::to_string(options_.seed);
    header.texts["data_hash"] = hash_of(*data_);
    return header;
  }

  /// Gives the leader's ranges to all.
  void share(std::vector<frf::IndexRange>& ranges) {
    std::vector<std::uint64_t> ends;
    for (const frf::IndexRange& range : ranges) ends.insert(ends.end(), {range.first, range.end});
    team_.share(ends);
    ranges.clear();
    for (std::size_t i = 0; i < ends.size(); i += 2) ranges.push_back({ends[i], ends[i + 1]});
  }

  void supervise(StudyRecords& records, std::span<const frf::IndexRange> missing, StudyRun& run) {
    const std::size_t done_before = run.done;
    std::size_t received = 0, others = team_.size() - 1;
    TrialQueue queue(part_of(missing, 0, team_.size()));
    StudyWorkers workers(data_, columns_, options_.seed, threads(), queue,
                         [&](std::size_t trial, std::span<const double> row) {
                           records.put(trial, row);
                           if (control_.row) control_.row(trial, row);
                         },
                         state_);
    Clock::time_point synced = Clock::now();
    for (bool ended = false; !ended || others > 0;) {
      ended = workers.wait_ms(team_.size() > 1 ? 2 : 50);
      while (const auto message = team_.receive()) {
        if (const auto* end = std::get_if<ident::TeamEnd>(&*message)) {
          --others;
          note_failure(end->failure);
        } else {
          received += store(std::get<std::vector<double>>(*message), records);
        }
      }
      if (is_interrupted()) state_.stop = true;
      if (state_.stop) team_.stop_others();
      run.computed = state_.computed + received;
      run.done = done_before + run.computed;
      if (control_.progress) control_.progress(run.done, options_.trials);
      if (run.computed > 0 && seconds_since(synced) > 5.0) {
        records.sync();
        synced = Clock::now();
      }
    }
    if (state_.computed > 0) run.solve_s = 1e-9 * static_cast<double>(state_.solve_ns) / static_cast<double>(state_.computed);
    if (state_.failure) std::rethrow_exception(state_.failure);
  }

  std::size_t store(std::span<const double> numbers, StudyRecords& records) const {
    const std::size_t step = 1 + columns_.count();
    for (std::size_t at = 0; at < numbers.size(); at += step) {
      records.put(static_cast<std::size_t>(numbers[at]), numbers.subspan(at + 1, columns_.count()));
    }
    return numbers.size() / step;
  }

  void note_failure(const std::string& text) {
    if (text.empty()) return;
    const std::lock_guard lock(state_.mutex);
    if (!state_.failure) state_.failure = ident::failure_elsewhere(text);
    state_.stop = true;
  }

  std::shared_ptr<const TrialData> data_;
  const StudyOptions& options_;
  ident::Team& team_;
  const StudyControl& control_;
  StudyColumns columns_;
  WorkerState state_;
};

}  // namespace

StudyRun run_study(const std::shared_ptr<const TrialData>& data, const StudyOptions& options, ident::Team& team,
                   const StudyControl& control) {
  const Clock::time_point start = Clock::now();
  Study study(data, options, team, control);
  StudyRun run = team.rank() == 0 ? study.lead() : study.follow();
  run.wall_s = seconds_since(start);
  return run;
}

}  // namespace jointid::study
