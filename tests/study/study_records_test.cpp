#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "study/trial_threads.hpp"
#include "tests/test_folder.hpp"

namespace jointid::study {
namespace {

TEST(RecordJournal, KnowsWhatIsWhole) {
  const TestFolder folder;
  const auto path = folder / "journal";
  using Start = frf::RecordJournal::Start;
  const frf::JournalKey key = {{"scene", "key"}, {"seed", "1"}}, other = {{"scene", "other"}, {"seed", "1"}};
  {
    frf::RecordJournal journal(path, key, 2, Start::fresh);
    journal.put(3, std::vector<double>{1.0, 2.0});
    journal.put(0, std::vector<double>{0.0, 0.0});
    EXPECT_THROW(frf::RecordJournal(path, key, 2, Start::resume), InputError) << "two on one journal";
  }
  EXPECT_THROW(frf::RecordJournal(path, key, 2, Start::fresh), InputError);
  EXPECT_THROW(frf::RecordJournal(path, other, 2, Start::resume), InputError);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  frf::RecordJournal journal(path, key, 2, Start::resume);
  EXPECT_EQ(journal.missing(5), (std::vector<frf::IndexRange>{{1, 5}}));
  journal.put(4, std::vector<double>{7.0, 8.0});
  journal.put(1, std::vector<double>{5.0, 6.0});
  EXPECT_EQ(journal.read(0, 2), (std::vector<double>{0.0, 0.0, 5.0, 6.0}));
  EXPECT_EQ(journal.missing(7), (std::vector<frf::IndexRange>{{2, 4}, {5, 7}}));
  EXPECT_EQ(journal.missing(1), std::vector<frf::IndexRange>());
}

TEST(RecordJournal, FindsWhatIsMissingOverManyRecords) {
  const TestFolder folder;
  frf::RecordJournal journal(folder / "journal", {{"scene", "key"}}, 1, frf::RecordJournal::Start::fresh);
  for (std::size_t i = 0; i < 10'000; ++i) {
    if (i < 4090 || i > 4100) journal.put(i, std::vector<double>{static_cast<double>(i)});
  }
  EXPECT_EQ(journal.missing(10'001), (std::vector<frf::IndexRange>{{4090, 4101}, {10'000, 10'001}}));
}

/// Every trial of the ranges, by asking `size` queues.
std::vector<std::size_t> handed_out(const std::vector<frf::IndexRange>& ranges, std::size_t size) {
  std::vector<std::size_t> trials;
  for (std::size_t rank = 0; rank < size; ++rank) {
    const std::vector<frf::IndexRange> part = part_of(ranges, rank, size);
    EXPECT_LE(count(part), (count(ranges) + size - 1) / size);
    TrialQueue queue(part);
    while (const auto trial = queue.next()) trials.push_back(*trial);
  }
  return trials;
}

TEST(TrialQueue, HandsOutEveryMissingTrialOnce) {
  const std::vector<frf::IndexRange> ranges = {{0, 3}, {7, 8}, {10, 15}};
  const std::vector<std::size_t> all = {0, 1, 2, 7, 10, 11, 12, 13, 14};
  for (const std::size_t size : {1u, 2u, 3u, 4u, 20u}) EXPECT_EQ(handed_out(ranges, size), all);
  EXPECT_EQ(handed_out({}, 3), std::vector<std::size_t>());
}

}  // namespace
}  // namespace jointid::study
