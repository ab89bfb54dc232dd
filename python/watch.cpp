#include "python/watch.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "base/stop_scope.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;
using std::chrono_literals::operator""ms;

std::atomic<int> left_to_themselves = 0;

/// What the thread that works and the one that waits for it share.
class Run {
 public:
  ident::Control control() {
    ident::Control out;
    out.progress = [this](const char* stage, std::size_t done, std::size_t total) { tell(stage, done, total); };
    out.interrupted = [this] { return stop_.load(std::memory_order_relaxed); };
    return out;
  }

  void stop() { stop_ = true; }

  void finish(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    error_ = std::move(error);
    done_ = true;
    if (left_) --left_to_themselves;
    changed_.notify_one();
  }

  /// Whether it is done after that time, or before.
  bool wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return done_; });
  }

  void leave() {
    const std::lock_guard lock(mutex_);
    left_ = !done_;
    if (left_) ++left_to_themselves;
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  /// Calls `progress` with what was told last, if anything was since the last call.
  void show(const py::object& progress) {
    std::unique_lock lock(mutex_);
    if (!told_) return;
    told_ = false;
    const std::string stage = stage_;
    const std::size_t done = steps_, total = total_;
    lock.unlock();
    progress(stage, done, total);
  }

 private:
  void tell(const char* stage, std::size_t done, std::size_t total) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    steps_ = done;
    total_ = total;
    told_ = true;
  }

  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false, left_ = false, told_ = false;
  std::exception_ptr error_;
  std::string stage_;
  std::size_t steps_ = 0, total_ = 0;
};

/// What Ctrl-C or the progress raise, or nothing.
std::exception_ptr look(Run& run, const py::object& progress, bool show) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (show && !progress.is_none()) run.show(progress);
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

bool wait_without_lock(Run& run, std::chrono::milliseconds time) {
  const py::gil_scoped_release release;
  return run.wait(time);
}

/// Null where the work came to its end by itself.
std::exception_ptr wait_for_end(Run& run, const py::object& progress) {
  for (int turn = 1; !wait_without_lock(run, 20ms); ++turn) {
    if (auto raised = look(run, progress, turn % 5 == 0)) return raised;
  }
  return look(run, progress, false);
}

/// Gives a KeyboardInterrupt what there is so far.
void add_partial(const std::exception_ptr& raised, const Partial& partial, bool ended) {
  if (!partial) return;
  try {
    std::rethrow_exception(raised);
  } catch (const py::error_already_set& error) {
    if (error.matches(PyExc_KeyboardInterrupt)) error.value().attr("partial") = partial(ended);
  } catch (...) {
    return;  // no exception of Python
  }
}

}  // namespace

void run_watched(const py::object& progress, std::function<void(const ident::Control&)> work, const Partial& partial) {
  const auto run = std::make_shared<Run>();
  std::thread thread([run, work = std::move(work)]() mutable {
    std::exception_ptr error;
    try {
      const ident::Control control = run->control();
      const StopScope::Ask ask = lasting(control.interrupted, 400ms);  // work that keeps something looks at `control` before
      const StopScope scope(&ask);
      work(control);
    } catch (...) {
      error = std::current_exception();
    }
    work = nullptr;  // with all that it owns, before the other thread goes on
    run->finish(std::move(error));
  });
  const std::exception_ptr raised = wait_for_end(*run, progress);
  if (raised) run->stop();
  const bool left = raised && !wait_without_lock(*run, 1500ms);
  if (left) {
    run->leave();
    thread.detach();
  } else {
    const py::gil_scoped_release release;
    thread.join();
  }
  if (raised) {
    add_partial(raised, partial, !left);
    std::rethrow_exception(raised);
  }
  run->rethrow();
}

std::function<bool()> lasting(std::function<bool()> interrupted, std::chrono::milliseconds time) {
  using Clock = std::chrono::steady_clock;
  auto since = std::make_shared<std::atomic<Clock::rep>>(0);  // 0: not interrupted yet
  return [interrupted = std::move(interrupted), time, since] {
    if (!interrupted()) return false;
    const Clock::rep now = Clock::now().time_since_epoch().count();
    Clock::rep first = 0;
    if (since->compare_exchange_strong(first, now)) return false;
    return Clock::duration(now - first) > time;
  };
}

int runs_left() noexcept { return left_to_themselves; }

}  // namespace jointid::python
