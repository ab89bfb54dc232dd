#include "base/stop_scope.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "base/control.hpp"

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

}  // namespace
}  // namespace jointid
