#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace jointid {

/// The threads that were asked for; for 0 all cores of the machine, or the part of them of each of so many processes.
inline std::size_t threads_or_cores(std::size_t asked, std::size_t processes = 1) {
  return asked > 0 ? asked : std::max<std::size_t>(1, std::thread::hardware_concurrency() / processes);
}

/// each(i) for i = 0 … count − 1 on as many threads, in any order. The first exception ends it and is thrown here.
template <class Each>
void for_each_index(std::size_t count, std::size_t threads, const Each& each) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i; (i = next++) < count;) each(i);
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads && t < count; ++t) others.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace jointid
