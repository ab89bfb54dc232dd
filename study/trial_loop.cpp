#include "study/trial_loop.hpp"

#include <limits>
#include <mutex>

#include "base/control.hpp"
#include "base/parallel.hpp"
#include "study/trial_threads.hpp"

namespace jointid::study {

std::vector<Trial> run_trials(const std::shared_ptr<const TrialData>& data, const TrialOptions& options) {
  std::vector<Trial> trials(options.trials);
  std::mutex reporting;
  std::size_t done = 0;
  work_through(options.trials, threads_or_cores(options.threads), options.interrupted, [&]() -> TrialWork {
    return [&, runner = std::make_shared<TrialRunner>(data, options.interrupted)](std::size_t trial) {
      stop_if(options.interrupted);
      trials[trial] = runner->run(options.seed, trial);
      if (!options.progress) return;
      const std::lock_guard lock(reporting);
      options.progress(++done, options.trials);
    };
  });
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
