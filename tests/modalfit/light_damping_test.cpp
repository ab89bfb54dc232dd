#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/random.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/noise_laws.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/residual_peaks.hpp"

namespace jointid::modalfit {
namespace {

struct TrueMode {
  double frequency_hz, zeta;
  std::vector<double> shape;  ///< [5], the response is the third point
};

/// Accelerances of one accelerometer and five hammer points as an analyser measures a steel beam: lines 1/51.2 Hz apart, about one line per
/// half-power bandwidth, 1 % noise and a floor; `drift` moves the frequencies from hammer point to hammer point, relative.
struct Rig {
  std::vector<TrueMode> modes = {{40.0, 1e-4, {0.9, 0.5, 0.8, -0.4, -0.9}},
                                 {112.0, 1e-4, {1.0, 0.3, 0.6, 0.7, -0.2}},
                                 {152.3, 1.2e-4, {0.4, 0.9, -0.7, 0.8, 0.6}},
                                 {230.0, 1e-4, {0.7, -0.6, 0.5, 0.9, 0.8}}};
  double low_hz = 100.0, high_hz = 170.0, drift = 0.0, noise = 0.01;
  std::uint64_t seed = 1;

  double frequency(const TrueMode& mode, std::size_t point) const {
    return mode.frequency_hz * (1.0 + drift * (static_cast<double>(point) - 2.0));
  }

  frf::FrfSet measured() const {
    frf::FrfSet set;
    set.header.quantity = frf::Quantity::accelerance;
    set.header.response = {frf::Dof::parse("3:-X")};
    for (int point = 1; point <= 5; ++point) set.header.reference.push_back(frf::Dof::parse(std::to_string(point) + ":+X"));
    for (double f = low_hz; f <= high_hz; f += 1.0 / 51.2) set.header.frequency_hz.push_back(f);
    for (std::size_t i = 0; i < set.header.lines(); ++i) {
      const double f = set.header.frequency_hz[i], omega = 2.0 * std::numbers::pi * f;
      for (std::size_t point = 0; point < 5; ++point) {
        Complex h = 1e-8;
        for (const TrueMode& mode : modes) {
          const double w = 2.0 * std::numbers::pi * frequency(mode, point);
          h -= mode.shape[2] * mode.shape[point] / Complex(w * w - omega * omega, 2.0 * mode.zeta * w * omega);
        }
        const auto n = normal_numbers({.seed = seed}, 5 * i + point);
        const double deviation = noise / std::sqrt(2.0) * (std::abs(h) + 0.1 / (omega * omega));
        set.values.push_back(h + deviation * Complex(n[0], n[1]));
      }
    }
    return set;
  }

  std::vector<double> inside(double low, double high) const {
    std::vector<double> out;
    for (const TrueMode& mode : modes) {
      if (mode.frequency_hz > low && mode.frequency_hz < high) out.push_back(mode.frequency_hz);
    }
    return out;
  }
};

ModalFit fitted_in(const frf::FrfSet& set, double low, double high, std::optional<std::size_t> modes = std::nullopt) {
  const FitOptions options{.range_hz = std::array{low, high}, .modes = modes};
  Band band = make_band(set, options.range_hz);
  return fit(band, set.header, options);
}

std::vector<Mode> modes_in(const ModalFit& fit) {
  std::vector<Mode> out;
  std::ranges::copy_if(fit.modes, std::back_inserter(out), [](const Mode& mode) { return mode.inside; });
  return out;
}

TEST(LightDamping, EveryModeIsFoundOnceInEveryRangeWithinItsDeviation) {
  Rig rig;
  const frf::FrfSet set = rig.measured();
  for (const std::array range : {std::array{100.0, 170.0}, std::array{105.0, 130.0}, std::array{140.0, 170.0}, std::array{111.0, 153.0}}) {
    const ModalFit found = fitted_in(set, range[0], range[1]);
    EXPECT_EQ(found.status, Status::ok) << found.message;
    const std::vector<double> exact = rig.inside(range[0], range[1]);
    const std::vector<Mode> modes = modes_in(found);
    ASSERT_EQ(modes.size(), exact.size()) << range[0] << ":" << range[1];
    for (std::size_t r = 0; r < modes.size(); ++r) {
      EXPECT_NEAR(modes[r].pole.frequency_hz, exact[r], 4.0 * modes[r].frequency_deviation_hz);
      EXPECT_LT(modes[r].frequency_deviation_hz, 0.1 * 1e-4 * exact[r]);
      EXPECT_NEAR(modes[r].pole.damping, rig.modes[exact[r] < 150.0 ? 1 : 2].zeta, 4.0 * modes[r].damping_deviation);
    }
  }
}

/// Each hammer point with frequencies of its own, a third of the half width apart from one to the next: one mode, known as well as the
/// points agree, and the same in every range.
TEST(LightDamping, FrequenciesThatDriftBetweenHammerPointsAreOneMode) {
  Rig rig;
  rig.drift = 3e-5;
  const frf::FrfSet set = rig.measured();
  std::vector<Mode> before;
  for (const std::array range : {std::array{100.0, 170.0}, std::array{108.0, 120.0}, std::array{110.5, 114.0}}) {
    const ModalFit found = fitted_in(set, range[0], range[1]);
    const std::vector<Mode> modes = modes_in(found);
    ASSERT_EQ(modes.size(), rig.inside(range[0], range[1]).size()) << range[0] << ":" << range[1];
    const Mode& mode = modes.front();
    EXPECT_NEAR(mode.pole.frequency_hz, 112.0, 3.0 * mode.frequency_deviation_hz);
    EXPECT_GT(mode.scatter, 2.0);
    EXPECT_GT(mode.frequency_deviation_hz, 0.2 * rig.drift * 112.0);
    EXPECT_LT(mode.frequency_deviation_hz, 2.0 * rig.drift * 112.0);
    EXPECT_NEAR(mode.own_hz[0], 112.0 * (1.0 - 2.0 * rig.drift), 0.7 * rig.drift * 112.0);
    EXPECT_NEAR(mode.own_hz[1], 112.0 * (1.0 + 2.0 * rig.drift), 0.7 * rig.drift * 112.0);
    if (!before.empty()) {
      EXPECT_NEAR(mode.pole.frequency_hz, before.front().pole.frequency_hz,
                  std::hypot(mode.frequency_deviation_hz, before.front().frequency_deviation_hz));
    }
    before = modes;
  }
}

/// Two modes nearer than their bandwidth with shapes of their own stay two.
TEST(LightDamping, ModesOfOtherShapesWithinABandwidthAreTwo) {
  Rig rig;
  rig.modes = {{112.0, 2e-3, {1.0, 0.3, 0.6, 0.7, -0.2}}, {112.35, 2e-3, {-0.5, 0.9, 0.6, -0.8, 0.9}}};
  const ModalFit found = fitted_in(rig.measured(), 105.0, 119.0);
  EXPECT_EQ(modes_in(found).size(), 2u);
}

TEST(LightDamping, FewerModesThanAskedForIsDoubtful) {
  Rig rig;
  const ModalFit found = fitted_in(rig.measured(), 108.0, 116.0, 3);
  if (found.modes_inside() != 3) {
    EXPECT_EQ(found.status, Status::doubtful);
    EXPECT_THAT(found.message, testing::HasSubstr("3 modes were asked for"));
  }
  EXPECT_TRUE(std::ranges::any_of(found.modes, [](const Mode& mode) { return std::abs(mode.pole.frequency_hz - 112.0) < 1e-3; }));
}

TEST(NoiseLaws, ALostModeDoesNotBecomeNoise) {
  const Rig rig;
  const frf::FrfSet set = rig.measured();
  Band band = make_band(set, {});
  estimate_noise(band, {0, 1, 2, 3, 4}, {}, {{152.3, 1.2e-4}});  // 112 Hz is missing
  const auto peak = static_cast<std::size_t>(std::lround((112.0 - rig.low_hz) * 51.2));
  for (std::size_t entry = 0; entry < 5; ++entry) {
    EXPECT_GT(std::abs(band.value(entry)[peak]) * band.weights(entry)[2 * peak], 50.0) << entry;
  }
}

/// With all modes in the model the law is that of the noise.
TEST(NoiseLaws, AreFoundWithoutBeingTold) {
  const Rig rig;
  const frf::FrfSet set = rig.measured();
  Band band = make_band(set, {});
  for (int pass = 0; pass < 2; ++pass) {  // the first weighs all lines alike
    estimate_noise(band, {0, 1, 2, 3, 4}, {}, {{40.0, 1e-4}, {112.0, 1e-4}, {152.3, 1.2e-4}, {230.0, 1e-4}});
  }
  for (std::size_t entry = 0; entry < 5; ++entry) {
    for (const double f : {104.0, 112.0, 135.0, 165.0}) {
      const auto i = static_cast<std::size_t>(std::lround((f - rig.low_hz) * 51.2));
      const double omega = 2.0 * std::numbers::pi * f;
      const double exact = rig.noise / std::sqrt(2.0) * (std::abs(band.value(entry)[i]) + 0.1 / (omega * omega));
      EXPECT_LT(1.0 / band.weights(entry)[2 * i], 1.6 * exact) << f;
      EXPECT_GT(1.0 / band.weights(entry)[2 * i], 0.6 * exact) << f;
    }
  }
}

TEST(ResidualPeaks, AreTheModesThatTheModelLacks) {
  const Rig rig;
  const frf::FrfSet set = rig.measured();
  const std::vector<std::size_t> entries = {0, 1, 2, 3, 4};
  Band band = make_band(set, {});
  estimate_noise(band, entries, {}, {{152.3, 1.2e-4}});
  const auto peaks = residual_peaks(band, entries, {}, {{152.3, 1.2e-4}});
  ASSERT_FALSE(peaks.empty());
  EXPECT_NEAR(peaks.front().pole.frequency_hz, 112.0, 1.0 / 51.2);
  EXPECT_LT(peaks.front().pole.damping, 1e-3);
  const std::vector<Pole> all = {{112.0, 1e-4}, {152.3, 1.2e-4}};
  estimate_noise(band, entries, {}, all);
  EXPECT_TRUE(residual_peaks(band, entries, {}, all).empty());
}

TEST(ResidualPeaks, ABadLineIsNone) {
  const Rig rig;
  frf::FrfSet set = rig.measured();
  for (std::size_t point = 0; point < 5; ++point) set.values[set.index(1500, 0, point)] *= 3.0;
  const std::vector<std::size_t> entries = {0, 1, 2, 3, 4};
  const std::vector<Pole> all = {{112.0, 1e-4}, {152.3, 1.2e-4}};
  Band band = make_band(set, {});
  estimate_noise(band, entries, {}, all);
  EXPECT_TRUE(residual_peaks(band, entries, {}, all).empty());
  const ModalFit found = fitted_in(set, 100.0, 170.0);
  EXPECT_EQ(found.modes_inside(), 2u);
}

TEST(Judge, AModelFarFromTheFrfsIsAPoorFit) {
  ModalFit good, off, none;
  none.status = Status::no_modes;
  judge(good, 0.3);
  judge(off, 5.6);
  judge(none, 5.6);
  EXPECT_EQ(good.status, Status::ok);
  EXPECT_EQ(off.status, Status::poor_fit);
  EXPECT_THAT(off.message, testing::HasSubstr("5.6 dB"));
  EXPECT_EQ(none.status, Status::no_modes);
  EXPECT_FALSE(is_usable(off.status));
  EXPECT_TRUE(is_usable(Status::doubtful));
}

}  // namespace
}  // namespace jointid::modalfit
