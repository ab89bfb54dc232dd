#include "weighting/line_selection.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace jointid::weighting {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<double> axis(double first, double step, std::size_t lines) {
  std::vector<double> frequency(lines);
  for (std::size_t i = 0; i < lines; ++i) frequency[i] = first + static_cast<double>(i) * step;
  return frequency;
}

LineSelection within(double low, double high, std::optional<double> step = {}) {
  return {.range_hz = {{low, high}}, .step_hz = step, .exclude_hz = {}};
}

std::vector<double> selected(const std::vector<double>& frequency, const LineSelection& selection) {
  std::vector<double> result;
  for (const std::size_t line : select_lines(frequency, selection)) result.push_back(frequency[line]);
  return result;
}

TEST(SelectLines, TakesAllLinesWithoutARange) { EXPECT_EQ(select_lines(axis(0.0, 1.0, 7), {}).size(), 7u); }

TEST(SelectLines, AnEmptyAxisHasNone) { EXPECT_THAT(select_lines({}, within(0.0, 1.0)), IsEmpty()); }

TEST(SelectLines, BothEndsOfARangeCount) {
  EXPECT_THAT(selected(axis(0.0, 1.0, 10), within(3.0, 5.0)), ElementsAre(3.0, 4.0, 5.0));
  EXPECT_THAT(selected(axis(0.0, 1.0, 10), within(3.1, 3.9)), IsEmpty());
  EXPECT_THAT(selected(axis(0.0, 1.0, 10), within(20.0, 30.0)), IsEmpty());
}

TEST(SelectLines, EndsAreMetWithinRounding) {
  // 0.1 as a sum misses the ends by some ulp.
  std::vector<double> frequency = {0.0};
  while (frequency.size() < 1001) frequency.push_back(frequency.back() + 0.1);
  ASSERT_NE(frequency[600], 60.0);
  const std::vector<std::size_t> lines = select_lines(frequency, within(40.0, 60.0));
  EXPECT_EQ(lines.front(), 400u);
  EXPECT_EQ(lines.back(), 600u);
  const std::vector<double> near = {1.0 - 1e-8, 1.0, 2.0, 2.0 + 1e-8};
  EXPECT_THAT(select_lines(near, within(1.0, 2.0)), ElementsAre(1u, 2u));
}

TEST(SelectLines, ExcludesClosedIntervalsWithTheirEnds) {
  EXPECT_THAT(selected(axis(0.0, 1.0, 8), {{}, {}, {{1.0, 2.0}, {4.5, 4.6}, {6.0, 20.0}}}),
              ElementsAre(0.0, 3.0, 4.0, 5.0));
}

TEST(SelectLines, AStepTakesTheNearestLines) {
  EXPECT_THAT(selected(axis(0.0, 0.7, 20), within(2.0, 8.0, 2.0)),
              ElementsAre(::testing::DoubleEq(2.1), ::testing::DoubleEq(4.2), ::testing::DoubleEq(6.3),
                          ::testing::DoubleEq(7.7)));
}

TEST(SelectLines, AStepFinerThanTheAxisTakesEveryLineOnce) {
  for (const double step : {0.6, 0.3, 1e-9}) {
    EXPECT_EQ(select_lines(axis(0.0, 1.0, 50), within(10.0, 20.0, step)).size(), 11u) << step;
  }
}

TEST(SelectLines, ARangeThatBeginsFarBelowTheAxisIsSteppedFromItsOwnBeginning) {
  EXPECT_THAT(selected(axis(1000.0, 1.0, 20), within(0.2, 1e9, 10.0)), ElementsAre(1000.0, 1010.0, 1019.0));
}

TEST(SelectLines, TheLastLineOfARoundedAxisIsTheNearestToTheLastStep) {
  // Increments rounded to four digits end a little before the range.
  EXPECT_THAT(selected(axis(0.0, 19.9999, 4), within(0.0, 60.0, 20.0)),
              ElementsAre(0.0, 19.9999, 39.9998, ::testing::DoubleEq(59.9997)));
}

/// All steps within the range, each by a search over the whole axis.
std::set<std::size_t> nearest_lines_plainly(const std::vector<double>& frequency, double low, double high,
                                            double step) {
  std::set<std::size_t> lines;
  for (std::size_t k = 0; low + static_cast<double>(k) * step <= high; ++k) {
    const double target = low + static_cast<double>(k) * step;
    std::size_t best = 0;
    for (std::size_t i = 1; i < frequency.size(); ++i) {
      if (std::abs(frequency[i] - target) < std::abs(frequency[best] - target)) best = i;
    }
    if (frequency[best] >= low && frequency[best] <= high) lines.insert(best);
  }
  return lines;
}

RC_GTEST_PROP(SelectLines, StepsEqualAPlainSearch, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double spacing = 0.1 + uniform(random);
  const std::vector<double> frequency = axis(10.0 * uniform(random), spacing, 60);
  const double low = 30.0 * uniform(random) - 5.0, high = low + 1.0 + 50.0 * uniform(random);
  const double step = spacing * (0.6 + 5.0 * uniform(random));
  const std::set<std::size_t> plain = nearest_lines_plainly(frequency, low, high, step);
  const std::vector<std::size_t> lines = select_lines(frequency, within(low, high, step));
  RC_ASSERT(std::is_sorted(lines.begin(), lines.end()));
  RC_ASSERT(lines == std::vector<std::size_t>(plain.begin(), plain.end()));
}

}  // namespace
}  // namespace jointid::weighting
