#include "base/stop_scope.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <thread>

#include "base/control.hpp"
#include "base/parallel.hpp"

namespace jointid {
namespace {

TEST(StopScope, NobodyAsksWithoutOne) {
  EXPECT_EQ(StopScope::current(), nullptr);
  EXPECT_NO_THROW(stop_point());
}

TEST(StopScope, StopsItsThreadAloneUntilItsEnd) {
  const StopScope::Ask stop = [] { return true; }, go_on = [] { return false; };
  {
    const StopScope outer(&stop);
    EXPECT_THROW(stop_point(), Interrupted);
    std::jthread([] { EXPECT_NO_THROW(stop_point()); }).join();
    {
      const StopScope inner(&go_on);
      EXPECT_NO_THROW(stop_point());
    }
    EXPECT_THROW(stop_point(), Interrupted);
  }
  EXPECT_NO_THROW(stop_point());
}

TEST(StopScope, LoopsOverIndicesHandItToTheirThreads) {
  constexpr std::size_t threads = 4;
  std::atomic<bool> is_over = false;
  const StopScope::Ask ask = [&] { return is_over.load(); };
  const StopScope scope(&ask);
  std::barrier all(threads);  // so that each thread is in one of the indices
  std::atomic<std::size_t> stopped = 0;
  const auto work = [&](std::size_t) {
    all.arrive_and_wait();
    is_over = true;
    try {
      stop_point();
    } catch (const Interrupted&) {
      ++stopped;
      throw;
    }
  };
  EXPECT_THROW(for_each_index(threads, threads, work), Interrupted);
  EXPECT_EQ(stopped, threads);
}

TEST(StopScope, LoopsOverIndicesStopBetweenTwo) {
  std::size_t done = 0;
  const StopScope::Ask ask = [&] { return done == 3; };
  const StopScope scope(&ask);
  EXPECT_THROW(for_each_index(1000, 1, [&](std::size_t) { ++done; }), Interrupted);
  EXPECT_EQ(done, 3U);
}

}  // namespace
}  // namespace jointid
