#include "report/text/frf_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace jointid::report {
namespace {

using ::testing::HasSubstr;

tasks::Regenerated one_frf(std::vector<Complex> measured, std::vector<Complex> predicted) {
  tasks::Regenerated regenerated;
  for (std::size_t i = 0; i < measured.size(); ++i) regenerated.frequency_hz.push_back(10.0 + static_cast<double>(i));
  regenerated.frfs.push_back({{frf::Dof::parse("1:+Y"), frf::Dof::parse("5:-Y")}, std::move(measured), std::move(predicted)});
  return regenerated;
}

std::string plot(const tasks::Regenerated& regenerated) { return frf_plot(regenerated, regenerated.frfs.front()); }

TEST(FrfPlot, EqualCurvesCoverEachOther) {
  const std::string text = plot(one_frf({1e-6, 1e-5, 1e-6}, {1e-6, 1e-5, 1e-6}));
  EXPECT_THAT(text, HasSubstr("assembly FRF 1:+Y / 5:-Y"));
  EXPECT_THAT(text, HasSubstr("rms difference 0 dB, FRAC 1.000000, LAC 1.000000"));
  // The title names '@' once; three lines are three marks, the peak in the top row.
  EXPECT_EQ(std::count(text.begin(), text.end(), '@'), 4);
  EXPECT_THAT(text, HasSubstr("-100 |"));
  EXPECT_THAT(text, HasSubstr("-120 |@"));
}

TEST(FrfPlot, AFactorOfTenIsTwentyDecibel) {
  const std::string text = plot(one_frf({1e-6, 1e-6}, {1e-5, 1e-5}));
  EXPECT_THAT(text, HasSubstr("rms difference 20 dB, FRAC 1.000000, LAC 0.198020"));
  EXPECT_THAT(text, HasSubstr("-100 |."));
  EXPECT_THAT(text, HasSubstr("-120 |o"));
}

TEST(FrfPlot, GapsStayEmptyAndNothingAtAllIsSaid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string gap = plot(one_frf({1e-6, {nan, nan}, 1e-6}, {1e-6, 1e-6, 1e-6}));
  EXPECT_THAT(gap, HasSubstr("rms difference 0 dB"));
  EXPECT_THAT(plot(one_frf({{nan, nan}}, {{nan, nan}})), HasSubstr("nothing to show"));
}

TEST(FrfPlot, OneLineIsEnough) { EXPECT_THAT(plot(one_frf({2e-6}, {2e-6})), HasSubstr("@")); }

}  // namespace
}  // namespace jointid::report
