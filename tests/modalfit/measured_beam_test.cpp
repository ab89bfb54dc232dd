#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "frf/set/frf_source.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/synthesis.hpp"
#include "tests/require.hpp"

namespace jointid::modalfit {
namespace {

class MeasuredBeam : public testing::Test {
 protected:
  void SetUp() override {
    const auto path = std::filesystem::path(JOINTID_EXTERNAL_DATA) / "beam-accelerances/beam.h5";
    if (!std::filesystem::exists(path)) JOINTID_SKIP(path << " is missing: no external data");
    set_ = frf::load(*frf::open(path));
  }
  frf::FrfSet set_;
};

/// The modes of the lightly damped beam and no other in every range, the same in all of them.
void expect_agreement(const frf::FrfSet& set, const std::vector<std::array<double, 2>>& ranges) {
  const std::array known = {111.9945, 306.8536, 596.371, 974.140};
  std::vector<Mode> seen;
  for (const std::array<double, 2>& range : ranges) {
    Band band = make_band(set, range);
    const ModalFit found = fit(band, set.header, {});
    EXPECT_EQ(found.status, Status::ok) << found.message;
    EXPECT_EQ(found.modes_inside(),
              static_cast<std::size_t>(std::ranges::count_if(known, [&](double f) { return f > range[0] && f < range[1]; })));
    for (const Mode& mode : found.modes) {
      if (!mode.inside) continue;
      for (const Mode& other : seen) {
        if (std::abs(other.pole.frequency_hz - mode.pole.frequency_hz) > 1.0) continue;
        EXPECT_NEAR(mode.pole.frequency_hz, other.pole.frequency_hz,
                    std::hypot(mode.frequency_deviation_hz, other.frequency_deviation_hz));
        EXPECT_NEAR(mode.pole.damping, other.pole.damping, 2.0 * std::hypot(mode.damping_deviation, other.damping_deviation));
      }
      EXPECT_TRUE(std::ranges::any_of(known, [&](double f) { return std::abs(mode.pole.frequency_hz - f) < 0.01; }));
      seen.push_back(mode);
    }
    frf::FrfHeader lines = set.header;
    lines.frequency_hz = band.frequency_hz;
    const auto errors =
        synthesis_errors(found, band, regenerate(found, lines, {band.frequency_hz.front(), band.frequency_hz.back()}));
    EXPECT_LT(overall(errors).rms_db_away, 0.6);
  }
}

/// 48,000 lines, and 530 about one of its modes.
TEST_F(MeasuredBeam, TheWholeRangeAgreesWithANarrowOne) { expect_agreement(set_, {{65.0, 1000.0}, {300.0, 310.0}}); }

/// 17,000 and 23,000 lines.
TEST_F(MeasuredBeam, PartsThatOverlapAgree) { expect_agreement(set_, {{65.0, 400.0}, {250.0, 700.0}}); }

}  // namespace
}  // namespace jointid::modalfit
