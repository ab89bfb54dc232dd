#include "report/modalfit/band_indicators.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace jointid::report {
namespace {

/// FRFs of a sum of modes A_r a_r b_rᵀ/(f_r² − f² + 0.02i f_r f) at whole frequencies.
struct PlantedMode {
  double frequency_hz, size;
  std::vector<double> responses, references;
};

modalfit::Band band_of(const std::vector<PlantedMode>& modes, std::size_t lines) {
  modalfit::Band band;
  band.responses = modes.front().responses.size();
  band.references = modes.front().references.size();
  for (std::size_t i = 1; i <= lines; ++i) band.frequency_hz.push_back(static_cast<double>(i));
  for (std::size_t e = 0; e < band.entries(); ++e) {
    for (const double f : band.frequency_hz) {
      std::complex<double> value = 0.0;
      for (const PlantedMode& mode : modes) {
        const std::complex<double> below(mode.frequency_hz * mode.frequency_hz - f * f, 0.02 * mode.frequency_hz * f);
        value += mode.size * mode.responses[e / band.references] * mode.references[e % band.references] / below;
      }
      band.values.push_back(value);
    }
  }
  return band;
}

TEST(Cmif, OfOneReferenceIsTheNormOfItsColumn) {
  const modalfit::Band band = band_of({{40.0, 1.0, {1.0, 2.0, 2.0}, {1.0}}}, 100);
  const Backdrop found = band_indicators(band, 2, 1000);
  ASSERT_EQ(found.series.size(), 1U);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(found.series[0].y[i] / (3.0 * std::abs(band.value(0)[i])), 1.0, 1e-12);
}

/// Two modes at one frequency with orthogonal shapes: the singular values are those of the modes.
TEST(Cmif, TheSecondTellsASecondModeAtTheSameFrequency) {
  const modalfit::Band band = band_of({{40.0, 1.0, {1.0, 1.0}, {1.0, 1.0}}, {40.0, 0.25, {1.0, -1.0}, {1.0, -1.0}}}, 100);
  const Backdrop found = band_indicators(band, 2, 1000);
  ASSERT_EQ(found.series.size(), 2U);
  const double peak = 2.0 / (0.02 * 40.0 * 40.0);
  EXPECT_NEAR(found.series[0].y[39] / peak, 1.0, 1e-12);
  EXPECT_NEAR(found.series[1].y[39] / (0.25 * peak), 1.0, 1e-12);
}

/// σ₁² + … is the squared norm, so with all singular values the norm of 20 references is bounded by that of the 12 that are used.
TEST(Cmif, ManyReferencesAndLinesAreThinnedAndPeaksStay) {
  const std::vector<double> shape(20, 1.0);
  const modalfit::Band band = band_of({{1234.0, 1.0, {1.0, 1.0}, shape}}, 5000);
  const Backdrop found = band_indicators(band, 1, 200);
  EXPECT_LE(found.x_values.size(), 200U);
  const auto peak = std::ranges::max_element(found.series[0].y) - found.series[0].y.begin();
  EXPECT_EQ(found.x_values[static_cast<std::size_t>(peak)], 1234.0);
  EXPECT_NEAR(*std::ranges::max_element(found.series[0].y) * 0.02 * 1234.0 * 1234.0, std::sqrt(24.0), 1e-3);
}

}  // namespace
}  // namespace jointid::report
