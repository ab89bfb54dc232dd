#include "minimise/least_value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace jointid {
namespace {

TEST(LeastValue, OfAParabolaIsAtItsVertexWithOneValueAStep) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 5.0), stretch(0.1, 20.0);
  for (int trial = 0; trial < 200; ++trial) {
    const double vertex = place(random), by = stretch(random);
    int values = 0;
    const auto of = [&](double x) { return ++values, by * (x - vertex) * (x - vertex); };
    EXPECT_NEAR(least_between(of, -2.0, 5.0, 1e-9), vertex, 1e-9);
    const double steps = std::log(7.0 / 1e-9) / std::log(0.5 * (1.0 + std::sqrt(5.0)));
    EXPECT_NEAR(values, steps + 2.0, 1.0);
  }
}

TEST(LeastValue, AtAnEndIsReached) {
  EXPECT_NEAR(least_between([](double x) { return x; }, 0.0, 1.0, 1e-8), 0.0, 1e-8);
  EXPECT_NEAR(least_between([](double x) { return -x; }, 0.0, 1.0, 1e-8), 1.0, 1e-8);
  EXPECT_NEAR(least_over([](double x) { return x; }, 2.0, 3.0, 10, 1e-8), 2.0, 1e-8);
  EXPECT_NEAR(least_over([](double x) { return -x; }, 2.0, 3.0, 10, 1e-8), 3.0, 1e-8);
}

TEST(LeastValue, OfSeveralMinimaIsTheDeepest) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const double deepest = place(random);
    const auto of = [&](double x) { return 4.0 * (x - deepest) * (x - deepest) - std::cos(30.0 * (x - deepest)); };
    EXPECT_NEAR(least_over(of, 0.0, 1.0, 60, 1e-9), deepest, 1e-8);
  }
}

}  // namespace
}  // namespace jointid
