#include "report/decimate.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace jointid::report {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Le;

using Values = std::vector<double>;

TEST(Decimate, FewPointsAreAllKept) {
  EXPECT_THAT(keep_peaks(std::vector<Values>{{3.0, 1.0, 2.0}}, 3), ElementsAre(0U, 1U, 2U));
  EXPECT_TRUE(keep_peaks({}, 10).empty());
}

TEST(Decimate, EveryPeakOfEveryCurveStays) {
  std::mt19937_64 random(1);
  std::vector<Values> curves(2, Values(100000));
  for (Values& curve : curves) {
    for (double& value : curve) value = std::uniform_real_distribution<double>(0.0, 1.0)(random);
  }
  curves[0][12345] = 9.0;
  curves[1][77777] = -9.0;
  const auto kept = keep_peaks(curves, 2400);
  EXPECT_THAT(kept.size(), Le(2400U));
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  EXPECT_EQ(kept.front(), 0U);
  EXPECT_EQ(kept.back(), 99999U);
  EXPECT_THAT(kept, Contains(12345U));
  EXPECT_THAT(kept, Contains(77777U));
}

/// Of a curve with one sharp resonance per piece, each is kept at its height.
TEST(Decimate, SharpResonancesKeepTheirHeight) {
  Values curve(50000, 1.0);
  for (std::size_t i = 250; i < curve.size(); i += 500) curve[i] = 100.0 + static_cast<double>(i);
  const Values left = picked(curve, keep_peaks(std::vector<Values>{curve}, 1000));
  for (std::size_t i = 250; i < curve.size(); i += 500) EXPECT_THAT(left, Contains(curve[i]));
}

TEST(Decimate, ValuesThatAreNotThereAreNoPeaks) {
  Values curve(1000, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(keep_peaks(std::vector<Values>{curve}, 40).size(), Le(40U));
  curve[501] = 5.0;
  EXPECT_THAT(keep_peaks(std::vector<Values>{curve}, 40), Contains(501U));
}

}  // namespace
}  // namespace jointid::report
