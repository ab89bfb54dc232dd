#include "report/peaks.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace jointid::report {
namespace {

std::vector<std::size_t> places(const std::vector<double>& y, double prominence_db = 6.0, std::size_t most = 40) {
  std::vector<double> x;
  for (std::size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<double>(i));
  std::vector<std::size_t> out;
  for (const Peak& peak : find_peaks(x, y, prominence_db, most)) {
    EXPECT_EQ(peak.x, x[peak.point]);
    EXPECT_EQ(peak.height, y[peak.point]);
    out.push_back(peak.point);
  }
  return out;
}

TEST(Peaks, RiseAboveTheValleysBesideThem) {
  EXPECT_THAT(places({1, 4, 1, 1.5, 1, 8, 1}), testing::ElementsAre(1U, 5U));
  EXPECT_THAT(places({1, 4, 1, 1.5, 1, 8, 1}, 3.0), testing::ElementsAre(1U, 3U, 5U));
  EXPECT_THAT(places({4, 5, 4, 8, 1}), testing::ElementsAre(3U));  // 5 is a shoulder of 8
}

TEST(Peaks, NoneOfEndsGapsAndFewPoints) {
  EXPECT_THAT(places({}), testing::IsEmpty());
  EXPECT_THAT(places({1, 2}), testing::IsEmpty());
  EXPECT_THAT(places({9, 1, 9}), testing::IsEmpty());
  EXPECT_THAT(places({1, std::nan(""), 5, 0, 1}), testing::ElementsAre(2U));
}

TEST(Peaks, OfManyTheHighestStayInOrder) {
  EXPECT_THAT(places({1, 4, 1, 9, 1, 5, 1}, 6.0, 2), testing::ElementsAre(3U, 5U));
}

}  // namespace
}  // namespace jointid::report
