#include "study/trial_queue.hpp"

#include <algorithm>

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

}  // namespace jointid::study
