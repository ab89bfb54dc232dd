#pragma once

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

}  // namespace jointid::study
