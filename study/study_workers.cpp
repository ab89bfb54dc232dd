#include "study/study_workers.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>
#include <condition_variable>

namespace jointid::study {

/// The caller watches and takes no part, so the arena has no place for it.
struct StudyWorkers::Threads {
  explicit Threads(std::size_t count)
      : allowance(oneapi::tbb::global_control::max_allowed_parallelism, count + 1),
        arena(static_cast<int>(count), 0),
        running(count) {}

  oneapi::tbb::global_control allowance;
  oneapi::tbb::task_arena arena;
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t running;
};

StudyWorkers::StudyWorkers(std::shared_ptr<const TrialData> data, const StudyColumns& columns, std::uint64_t seed,
                           std::size_t threads, TrialQueue& queue, Put put, WorkerState& state)
    : data_(std::move(data)),
      columns_(columns),
      seed_(seed),
      queue_(queue),
      put_(std::move(put)),
      state_(state),
      threads_(std::make_unique<Threads>(threads)) {
  for (std::size_t i = 0; i < threads; ++i) threads_->arena.enqueue([this] { work(); });
}

StudyWorkers::~StudyWorkers() {
  state_.stop = true;
  std::unique_lock lock(threads_->mutex);
  threads_->ended.wait(lock, [this] { return threads_->running == 0; });
}

bool StudyWorkers::wait_ms(int milliseconds) {
  std::unique_lock lock(threads_->mutex);
  return threads_->ended.wait_for(lock, std::chrono::milliseconds(milliseconds), [this] { return threads_->running == 0; });
}

void StudyWorkers::work() {
  try {
    TrialRunner runner(data_);
    std::vector<double> row(columns_.count());
    while (!state_.stop) {
      const auto number = queue_.next();
      if (!number) break;
      const Trial trial = runner.run(seed_, *number);
      fill_row(trial, columns_, row);
      put_(*number, row);
      ++state_.computed;
      state_.solve_ns += static_cast<std::uint64_t>(1e9 * trial.solve_s);
    }
  } catch (...) {
    const std::lock_guard lock(state_.mutex);
    if (!state_.failure) state_.failure = std::current_exception();
    state_.stop = true;
  }
  const std::lock_guard lock(threads_->mutex);
  if (--threads_->running == 0) threads_->ended.notify_all();
}

}  // namespace jointid::study
