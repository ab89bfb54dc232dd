#include <gtest/gtest.h>

#include <numeric>

#include "stability/sweeps.hpp"

namespace jointid::stability {
namespace {

/// A hundred scenes per case, so that a test run shares them among its cores.
class Promises : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Promises, NoSilentWrongAnswer) {
  const Count count = count_verdicts(1, 100 * GetParam(), 100);
  EXPECT_EQ(count.silent_wrong, 0u) << "first scene " << (count.silent.empty() ? 0 : count.silent.front());
  EXPECT_EQ(count.refused, 0u);
  // The scenes are not all hopeless: a program that only warns would pass otherwise.
  EXPECT_GE(count.right, 10u);
  RecordProperty("false_alarm", static_cast<int>(count.false_alarm));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Promises, testing::Range<std::uint64_t>(0, 20));

}  // namespace
}  // namespace jointid::stability
