#include "laws/task/shared_trials.hpp"

#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "base/control.hpp"
#include "study/shared_trials.hpp"

namespace jointid::laws {
namespace {

/// What the leader has of a study.
class KnownTrials {
 public:
  explicit KnownTrials(const LawStudyOptions& options) : options_(options), trials_(options.trials), is_known_(options.trials) {
    for (const LawTrial& trial : options.known) {
      if (trial.trial < trials_.size()) keep(trial);
    }
  }

  std::vector<frf::IndexRange> missing() const {
    std::vector<frf::IndexRange> out;
    for (std::size_t trial = 0; trial < trials_.size(); ++trial) {
      if (is_known_[trial]) continue;
      if (out.empty() || out.back().end != trial) out.push_back({trial, trial});
      ++out.back().end;
    }
    return out;
  }

  void put(const LawTrial& trial) {
    const std::scoped_lock lock(mutex_);
    keep(trial);
    if (options_.made) options_.made(trial);
    if (options_.progress) options_.progress(count_, trials_.size());
  }

  std::vector<LawTrial> all() { return std::move(trials_); }

 private:
  void keep(const LawTrial& trial) {
    trials_[trial.trial] = trial;
    if (!is_known_[trial.trial]) ++count_;
    is_known_[trial.trial] = true;
  }

  const LawStudyOptions& options_;
  std::vector<LawTrial> trials_;
  std::vector<bool> is_known_;
  std::size_t count_ = 0;
  std::mutex mutex_;
};

/// A trial as numbers: the bytes of its line.
void to_row(const LawTrial& trial, std::size_t values, std::vector<double>& row) {
  const std::string line = line_of(trial, values);
  row.assign(line.begin(), line.end());
}

LawTrial of_row(std::span<const double> row, std::size_t values) {
  std::string line;
  for (const double byte : row) line.push_back(static_cast<char>(byte));
  line.pop_back();  // its end
  return *trial_of(line, values);
}

}  // namespace

std::optional<std::vector<LawTrial>> trials_made_together(const MakeTrial& make, std::size_t values,
                                                          const LawStudyOptions& options, ident::Team& team) {
  std::optional<KnownTrials> known;
  if (team.rank() == 0) known.emplace(options);
  const auto maker = [&]() -> study::MakeTrialRow {
    return [&](std::size_t trial, std::vector<double>& row) {
      stop_if(options.interrupted);
      to_row(make(trial), values, row);
    };
  };
  study::share_trials(known ? known->missing() : std::vector<frf::IndexRange>(), team,
                      {.threads = options.threads,
                       .maker = maker,
                       .keep = [&](std::size_t, std::span<const double> row) { known->put(of_row(row, values)); },
                       .interrupted = options.interrupted});
  if (!known) return std::nullopt;
  stop_if(options.interrupted);
  return known->all();
}

}  // namespace jointid::laws
