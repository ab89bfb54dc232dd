#include "study/trial_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/control.hpp"
#include "study/shared_trials.hpp"
#include "tests/ident/thread_team.hpp"

namespace jointid::study {
namespace {

TEST(TrialThreads, MakeEveryTrialOnceEachThreadWithWorkOfItsOwn) {
  constexpr std::size_t trials = 200;
  std::vector<std::atomic<int>> times(trials);
  std::atomic<int> works = 0;
  work_through(trials, 3, {}, [&]() -> TrialWork {
    ++works;
    return [&times, maker = std::this_thread::get_id()](std::size_t trial) {
      EXPECT_EQ(std::this_thread::get_id(), maker);
      ++times[trial];
    };
  });
  for (const std::atomic<int>& each : times) EXPECT_EQ(each, 1);
  EXPECT_EQ(works, 3);
  work_through(0, 3, {}, [&]() -> TrialWork { throw std::logic_error("no trial, no work"); });
}

TEST(TrialThreads, ThrowWhatTheWorkThrowsAndInterruptions) {
  std::atomic<std::size_t> made = 0;
  const MakeTrialWork fails = [&]() -> TrialWork {
    return [&](std::size_t trial) {
      if (trial == 5) throw std::runtime_error("no memory left");
      ++made;
    };
  };
  EXPECT_THROW(work_through(1000, 2, {}, fails), std::runtime_error);
  EXPECT_LT(made, 1000u);
  const MakeTrialWork endless = [&]() -> TrialWork {
    return [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  };
  EXPECT_THROW(work_through(std::size_t{1} << 40, 2, [] { return true; }, endless), Interrupted);
}

/// Rows of different lengths come to the leader as they are made, those of the ranges alone.
TEST(SharedTrials, OfATeamAreKeptByTheLeaderOnceEach) {
  std::map<std::size_t, std::vector<double>> kept;
  std::mutex mutex;
  std::vector<std::size_t> made(3, 0);
  std::size_t watched = 0;
  const auto thrown = ident::ThreadTeam(3).run([&](ident::Team& member) {
    const bool leads = member.rank() == 0;
    const auto maker = []() -> MakeTrialRow {
      return [](std::size_t trial, std::vector<double>& row) { row.assign(trial % 4, static_cast<double>(trial)); };
    };
    TrialSharing sharing{.threads = 2, .maker = maker, .keep = {}};
    if (leads) {
      sharing.keep = [&](std::size_t trial, std::span<const double> row) {
        const std::scoped_lock lock(mutex);
        EXPECT_TRUE(kept.emplace(trial, std::vector<double>(row.begin(), row.end())).second);
      };
      sharing.watch = [&](std::size_t all) { watched = all; };
    }
    const std::vector<frf::IndexRange> missing = {{2, 9}, {20, 33}};
    made[member.rank()] = share_trials(leads ? missing : std::vector<frf::IndexRange>(), member, sharing);
  });
  for (const std::exception_ptr& each : thrown) EXPECT_FALSE(each);
  EXPECT_EQ(kept.size(), 20u);
  for (const auto& [trial, row] : kept) {
    EXPECT_TRUE((trial >= 2 && trial < 9) || (trial >= 20 && trial < 33)) << trial;
    EXPECT_EQ(row, std::vector<double>(trial % 4, static_cast<double>(trial)));
  }
  EXPECT_EQ(made[0], 20u);
  EXPECT_EQ(watched, 20u);
  EXPECT_EQ(made[1] + made[2], 13u);  // parts of 7, 7 and 6
}

}  // namespace
}  // namespace jointid::study
