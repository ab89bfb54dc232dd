#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "study/trial_runner.hpp"

namespace jointid::study {

/// Which trials are run and how; progress and interrupted are optional, and progress is called by one thread at a time.
struct TrialOptions {
  std::size_t trials = 200;  ///< > 0
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< 0: all cores. Only the run times depend on it.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
  std::function<bool()> interrupted = {};
};

/// Trials 0 … trials−1 of the seed, in that order, each thread with a runner of its own. Throws Interrupted when asked to end.
std::vector<Trial> run_trials(const std::shared_ptr<const TrialData>& data, const TrialOptions& options);

/// RJCF, ARVF or rms error (`figure`) of the judged matrix number `matrix`; NaN unless the trial's status is ok.
double figure_of(const Trial& trial, std::size_t matrix, double ident::Quality::*figure);

/// `options` for part `part` of `parts` with as many trials each: progress counts those of all parts.
TrialOptions counting_parts(TrialOptions options, std::size_t part, std::size_t parts);

}  // namespace jointid::study
