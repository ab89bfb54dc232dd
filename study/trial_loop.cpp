#include "study/trial_loop.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <limits>
#include <mutex>

namespace jointid::study {

std::vector<Trial> run_trials(const std::shared_ptr<const TrialData>& data, const TrialOptions& options) {
  std::vector<Trial> trials(options.trials);
  tbb::enumerable_thread_specific<TrialRunner> runners([&] { return TrialRunner(data, options.interrupted); });
  std::mutex reporting;
  std::size_t done = 0;
  const auto run_one = [&](std::size_t trial) {
    stop_if(options.interrupted);
    trials[trial] = runners.local().run(options.seed, trial);
    if (!options.progress) return;
    const std::lock_guard lock(reporting);
    options.progress(++done, options.trials);
  };
  const int threads = options.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(options.threads);
  tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t{0}, options.trials, run_one); });
  return trials;
}

double figure_of(const Trial& trial, std::size_t matrix, double ident::Quality::*figure) {
  if (!is_usable(trial.status)) return std::numeric_limits<double>::quiet_NaN();
  return trial.quality.at(matrix).*figure;
}

TrialOptions counting_parts(TrialOptions options, std::size_t part, std::size_t parts) {
  if (!options.progress) return options;
  options.progress = [part, parts, report = std::move(options.progress)](std::size_t done, std::size_t total) {
    report(part * total + done, parts * total);
  };
  return options;
}

}  // namespace jointid::study
