#include "study/trial_threads.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "base/control.hpp"

namespace jointid::study {

std::size_t count(std::span<const frf::IndexRange> ranges) {
  std::size_t sum = 0;
  for (const frf::IndexRange& range : ranges) sum += range.end - range.first;
  return sum;
}

std::vector<frf::IndexRange> part_of(std::span<const frf::IndexRange> ranges, std::size_t rank, std::size_t size) {
  const std::size_t all = count(ranges), each = all / size, longer = all % size;
  std::size_t skip = rank * each + std::min(rank, longer), left = each + (rank < longer ? 1 : 0);
  std::vector<frf::IndexRange> part;
  for (const frf::IndexRange& range : ranges) {
    const std::size_t length = range.end - range.first, before = std::min(skip, length), taken = std::min(left, length - before);
    if (taken > 0) part.push_back({range.first + before, range.first + before + taken});
    skip -= before;
    left -= taken;
  }
  return part;
}

std::optional<std::size_t> TrialQueue::next() {
  const std::lock_guard lock(mutex_);
  while (at_ < open_.size() && open_[at_].first == open_[at_].end) ++at_;
  if (at_ == open_.size()) return std::nullopt;
  return open_[at_].first++;
}

/// The caller watches and takes no part, so the arena has no place for it.
struct TrialThreads::State {
  State(std::vector<frf::IndexRange> trials, std::size_t count, MakeTrialWork make_work)
      : queue(std::move(trials)),
        make(std::move(make_work)),
        allowance(oneapi::tbb::global_control::max_allowed_parallelism, count + 1),
        arena(static_cast<int>(std::max<std::size_t>(1, count)), 0),
        running(count) {
    for (std::size_t i = 0; i < count; ++i) arena.enqueue([this] { work(); });
  }

  void work() {
    try {
      make_trials();
    } catch (...) {
      stop = true;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    if (--running == 0) ended.notify_all();
  }

  void make_trials() {
    const TrialWork each = make();
    while (!stop) {
      const auto trial = queue.next();
      if (!trial) break;
      each(*trial);
      ++made;
    }
  }

  TrialQueue queue;
  MakeTrialWork make;
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> made = 0;
  std::mutex mutex;  ///< of what follows
  std::condition_variable ended;
  std::exception_ptr failure;
  oneapi::tbb::global_control allowance;
  oneapi::tbb::task_arena arena;
  std::size_t running;
};

TrialThreads::TrialThreads(std::vector<frf::IndexRange> trials, std::size_t threads, MakeTrialWork make) {
  const std::size_t count = std::min(std::max<std::size_t>(1, threads), study::count(trials));
  state_ = std::make_unique<State>(std::move(trials), count, std::move(make));
}

TrialThreads::~TrialThreads() {
  stop();
  std::unique_lock lock(state_->mutex);
  state_->ended.wait(lock, [this] { return state_->running == 0; });
}

bool TrialThreads::wait_ms(int milliseconds) {
  std::unique_lock lock(state_->mutex);
  return state_->ended.wait_for(lock, std::chrono::milliseconds(milliseconds), [this] { return state_->running == 0; });
}

void TrialThreads::stop() { state_->stop = true; }

bool TrialThreads::is_stopped() const { return state_->stop; }

std::size_t TrialThreads::made() const { return state_->made; }

std::exception_ptr TrialThreads::failure() const {
  const std::lock_guard lock(state_->mutex);
  return state_->failure;
}

void work_through(std::size_t count, std::size_t threads, const std::function<bool()>& interrupted, const MakeTrialWork& make) {
  TrialThreads all({{0, count}}, threads, make);
  while (!all.wait_ms(50)) {
    if (interrupted && interrupted()) all.stop();
  }
  if (const std::exception_ptr failure = all.failure()) std::rethrow_exception(failure);
  if (all.made() < count) throw Interrupted();
}

}  // namespace jointid::study
