#include "study/study.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "study/shared_trials.hpp"
#include "study/study_records.hpp"
#include "study/study_row.hpp"
#include "study/trial_threads.hpp"

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
      : data_(data), options_(options), range_(trials_of(options.part, options.trials)), team_(team), control_(control) {}

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
    const std::size_t all = range_.end - range_.first, done_before = all - count(missing);
    run.computed = share_trials(std::move(missing), team_, leading(records, done_before));
    run.done = done_before + run.computed;
    if (solved_ > 0) run.solve_s = 1e-9 * static_cast<double>(solve_ns_) / static_cast<double>(solved_);
    run.complete = run.done == all;
    if (run.complete) records.finish();
    return run;
  }

  StudyRun follow() {
    start_together(team_, [&] { choose_columns(); });
    StudyRun run;
    run.done = run.computed = share_trials({}, team_, sharing());
    return run;
  }

 private:
  void choose_columns() { columns_ = columns_of(*data_, has_intervals(data_, options_.seed)); }

  frf::TableHeader header() const {
    frf::TableHeader header = header_of(*data_, columns_);
    header.texts.insert(options_.texts.begin(), options_.texts.end());
    header.texts.merge(texts_of(options_.part, options_.trials, data_->scene.title, data_->notes));
    header.texts["seed"] = std::to_string(options_.seed);
    header.texts["data_hash"] = hash_of(*data_);
    return header;
  }

  TrialSharing sharing() {
    const auto maker = [this]() -> MakeTrialRow {
      return [this, runner = std::make_shared<TrialRunner>(data_)](std::size_t index, std::vector<double>& row) {
        const std::size_t number = range_.first + index;
        const Trial trial = runner->run(options_.seed, number);
        solve_ns_ += static_cast<std::uint64_t>(1e9 * trial.solve_s);
        ++solved_;
        row.resize(columns_.count());
        fill_row(trial, columns_, row);
        if (team_.rank() == 0 && control_.row) control_.row(number, row);
      };
    };
    return {.threads = threads_or_cores(options_.threads), .maker = maker, .keep = {}, .interrupted = control_.interrupted};
  }

  TrialSharing leading(StudyRecords& records, std::size_t done_before) {
    constexpr double between_syncs_s = 5.0;
    TrialSharing out = sharing();
    out.keep = [&records](std::size_t trial, std::span<const double> row) { records.put(trial, row); };
    out.watch = [this, &records, done_before, synced = Clock::now()](std::size_t made) mutable {
      if (control_.progress) control_.progress(done_before + made, range_.end - range_.first);
      if (made == 0 || seconds_since(synced) <= between_syncs_s) return;
      records.sync();
      synced = Clock::now();
    };
    return out;
  }

  std::shared_ptr<const TrialData> data_;
  const StudyOptions& options_;
  frf::IndexRange range_;  ///< of the trials; those of the records begin with 0
  ident::Team& team_;
  const StudyControl& control_;
  StudyColumns columns_;
  std::atomic<std::size_t> solved_ = 0;
  std::atomic<std::uint64_t> solve_ns_ = 0;
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
