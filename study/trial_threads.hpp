#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "frf/hdf5/record_journal.hpp"

namespace jointid::study {

/// How many indices the ranges hold.
std::size_t count(std::span<const frf::IndexRange> ranges);

/// The part of `ranges` that is for process `rank` of `size`: parts are as large as each other (to one), each in one piece, and
/// so what is done after an interruption stays a few ranges.
std::vector<frf::IndexRange> part_of(std::span<const frf::IndexRange> ranges, std::size_t rank, std::size_t size);

/// Hands out trials one by one in ascending order, to any number of threads.
class TrialQueue {
 public:
  explicit TrialQueue(std::vector<frf::IndexRange> open) : open_(std::move(open)) {}
  std::optional<std::size_t> next();

 private:
  std::mutex mutex_;
  std::vector<frf::IndexRange> open_;
  std::size_t at_ = 0;  ///< range under way
};

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
