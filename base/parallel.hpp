#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/stop_scope.hpp"

namespace jointid {

/// The threads that were asked for; for 0 all cores of the machine, or the part of them of each of so many processes.
inline std::size_t threads_or_cores(std::size_t asked, std::size_t processes = 1) {
  return asked > 0 ? asked : std::max<std::size_t>(1, std::thread::hardware_concurrency() / processes);
}

/// Begins work on so many threads beside this one, or on as many as the system lets it have (limits of memory or processes).
template <class Work>
std::vector<std::jthread> threads_of(std::size_t count, const Work& work) {
  std::vector<std::jthread> threads;
  try {
    for (std::size_t t = 0; t < count; ++t) threads.emplace_back(work);
  } catch (const std::system_error&) {
  }
  return threads;
}

/// each(i) for i = 0 … count − 1 on as many threads, in any order. The first exception ends it and is thrown here. All threads have the
/// StopScope of this one, and stop between two of them.
template <class Each>
void for_each_index(std::size_t count, std::size_t threads, const Each& each) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr error;
  std::mutex mutex;
  const StopScope::Ask* const asked = StopScope::current();
  const auto work = [&] {
    const StopScope scope(asked);
    try {
      for (std::size_t i; (i = next++) < count;) {
        stop_point();
        each(i);
      }
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    const auto others = threads_of(std::max<std::size_t>(1, std::min(threads, count)) - 1, work);
    work();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace jointid
