#pragma once

#include <condition_variable>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace jointid::study {

/// Rows on their way to the leader: trial number and row, one after the other. Who puts waits while it is full.
class Outbox {
 public:
  void put(std::size_t trial, std::span<const double> row) {
    std::unique_lock lock(mutex_);
    taken_.wait(lock, [this] { return numbers_.size() < most_numbers; });
    numbers_.push_back(static_cast<double>(trial));
    numbers_.insert(numbers_.end(), row.begin(), row.end());
  }

  std::vector<double> take() {
    const std::lock_guard lock(mutex_);
    taken_.notify_all();
    return std::exchange(numbers_, {});
  }

 private:
  static constexpr std::size_t most_numbers = 1 << 20;

  std::mutex mutex_;
  std::condition_variable taken_;
  std::vector<double> numbers_;
};

}  // namespace jointid::study
