#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

#include "frf/hdf5/record_journal.hpp"

namespace jointid::study {

/// Makes the trial of a number and puts what it found where it belongs.
using TrialWork = std::function<void(std::size_t trial)>;

/// The work of one thread, made in it before its first trial: what works on one trial after the other need not be shared.
using MakeTrialWork = std::function<TrialWork()>;

/// Works through trials on threads beside the caller, in ascending order of their numbers, until all are made or stop() is called. The
/// first exception of any work ends all.
class TrialThreads {
 public:
  /// No more threads than trials.
  TrialThreads(std::vector<frf::IndexRange> trials, std::size_t threads, MakeTrialWork make);
  /// Stops, and waits for the trials under way.
  ~TrialThreads();

  /// Waits at most so long; true when all threads have ended.
  bool wait_ms(int milliseconds);

  /// No thread begins another trial.
  void stop();
  bool is_stopped() const;

  /// How many trials are made.
  std::size_t made() const;

  /// What ended the work early; empty: nothing.
  std::exception_ptr failure() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Trials 0 … count−1 by that work; `interrupted` is asked several times per second by the calling thread. Throws what the work throws,
/// and Interrupted.
void work_through(std::size_t count, std::size_t threads, const std::function<bool()>& interrupted, const MakeTrialWork& make);

}  // namespace jointid::study
