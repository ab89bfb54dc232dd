#include "base/stop_scope.hpp"

#include <gtest/gtest.h>

#include <atomic>
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

TEST(StopScope, EndsLoopsOnSeveralThreads) {
  std::atomic<int> begun = 0;
  const StopScope::Ask after_ten = [&] { return begun > 10; };
  const StopScope scope(&after_ten);
  EXPECT_THROW(for_each_index(100000, 4, [&](std::size_t) { ++begun; }), Interrupted);
  EXPECT_LT(begun, 100);
}

TEST(StopScope, ThreadsAskAsTheOneThatBeganThem) {
  const StopScope::Ask stop = [] { return true; };
  std::atomic<int> stopped = 0;
  {
    const StopScope scope(&stop);
    const auto threads = threads_of(3, [&] {
      try {
        stop_point();
      } catch (const Interrupted&) {
        ++stopped;
      }
    });
  }
  EXPECT_EQ(stopped, 3);
}

}  // namespace
}  // namespace jointid
