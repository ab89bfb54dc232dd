#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>

#include "study/study_row.hpp"
#include "study/trial_queue.hpp"

namespace jointid::study {

/// What the workers of a process are told and tell.
struct WorkerState {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> computed = 0;
  std::atomic<std::uint64_t> solve_ns = 0;

  std::mutex mutex;  ///< of the failure
  std::exception_ptr failure;
};

/// Runs trials on `threads` threads beside the caller until the queue is empty or `state` says stop; the first exception ends
/// all and is kept in `state`.
class StudyWorkers {
 public:
  using Put = std::function<void(std::size_t trial, std::span<const double> row)>;

  /// `put` is called from several threads at once.
  StudyWorkers(std::shared_ptr<const TrialData> data, const StudyColumns& columns, std::uint64_t seed, std::size_t threads,
               TrialQueue& queue, Put put, WorkerState& state);
  ~StudyWorkers();

  /// Waits at most so long; true when all are done.
  bool wait_ms(int milliseconds);

 private:
  struct Threads;
  void work();

  std::shared_ptr<const TrialData> data_;
  StudyColumns columns_;
  std::uint64_t seed_;
  TrialQueue& queue_;
  Put put_;
  WorkerState& state_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace jointid::study
