#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "frf/mat/mat_module.hpp"
#include "frf/set/frf_source.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/synthesis.hpp"
#include "tests/require.hpp"

namespace jointid::modalfit {
namespace {

class MeasuredModes : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) {
    const auto path = std::filesystem::path(JOINTID_EXTERNAL_DATA) / name;
    return path;
  }
};

TEST_F(MeasuredModes, SixResonancesOfAFreeBeam) {
  const auto path = file("uff/measurement.uff");
  if (!std::filesystem::exists(path)) JOINTID_SKIP(path << " is missing: no external data");
  const frf::FrfSet set = frf::load(*frf::open(path));
  Band band = make_band(set, {});
  const ModalFit found = fit(band, set.header, {});
  EXPECT_EQ(found.status, Status::ok) << found.message;
  for (const double resonance : {52.0, 142.0, 279.0, 460.0, 687.0, 959.0}) {
    EXPECT_TRUE(std::ranges::any_of(found.modes, [&](const Mode& mode) { return std::abs(mode.pole.frequency_hz - resonance) < 0.6; }))
        << resonance;
  }
  EXPECT_LE(found.modes_inside(), 8u);
  frf::FrfHeader lines = set.header;
  lines.frequency_hz = band.frequency_hz;
  const auto errors = synthesis_errors(found, band, regenerate(found, lines, {band.frequency_hz.front(), band.frequency_hz.back()}));
  for (const SynthesisError& error : errors) {
    EXPECT_LT(error.rms_db_away, 1.0);
    EXPECT_GT(error.lines_away, 500u);
    EXPECT_LT(error.rms_db, 1.0);  // near antiresonances, too
  }
}

/// The first lines tell the noise of the others nothing; without them the fit has to find another one, from neighbouring lines.
TEST_F(MeasuredModes, TheScatterOfNeighbouringLinesExplainsMostOfWhatIsLeft) {
  const auto path = file("uff/measurement.uff");
  if (!std::filesystem::exists(path)) JOINTID_SKIP(path << " is missing: no external data");
  const frf::FrfSet set = frf::load(*frf::open(path));
  for (const double low : {5.0, 20.0}) {
    Band band = make_band(set, std::array{low, 1000.0});
    const ModalFit found = fit(band, set.header, {});
    EXPECT_GT(found.cost / found.freedom, 0.9) << low;
    EXPECT_LT(found.cost / found.freedom, 1.6) << low;
    EXPECT_TRUE(std::ranges::any_of(found.modes, [](const Mode& mode) { return std::abs(mode.pole.frequency_hz - 900.87) < 0.1; })) << low;
    EXPECT_EQ(found.modes_inside(), 7u) << low;
  }
}

/// A beam with ζ of 0.01 %, about one line per half-power bandwidth at 112 Hz. A separate rational fit of the same data: 111.99, 306.85,
/// 596.37 and 974.14 Hz.
TEST_F(MeasuredModes, OfALightlyDampedBeamAreFoundOnceInEveryRange) {
  const auto path = file("beam-accelerances/beam.h5");
  if (!std::filesystem::exists(path)) JOINTID_SKIP(path << " is missing: no external data");
  const frf::FrfSet set = frf::load(*frf::open(path));
  const std::array known = {111.9945, 306.8536, 596.371, 974.140};
  for (const std::array range : {std::array{105.0, 120.0}, std::array{111.0, 113.0}, std::array{300.0, 310.0}, std::array{590.0, 602.0},
                                 std::array{960.0, 1000.0}}) {
    Band band = make_band(set, range);
    const ModalFit found = fit(band, set.header, {});
    EXPECT_EQ(found.status, Status::ok) << found.message;
    std::size_t expected = 0;
    for (const double f : known) {
      if (f < range[0] || f > range[1]) continue;
      ++expected;
      const auto near = std::ranges::find_if(found.modes, [&](const Mode& mode) { return std::abs(mode.pole.frequency_hz - f) < 0.02; });
      ASSERT_NE(near, found.modes.end()) << f << " in " << range[0] << ":" << range[1];
      EXPECT_NEAR(near->pole.frequency_hz, f, 2.0 * near->frequency_deviation_hz);
      EXPECT_LT(near->frequency_deviation_hz, 1.2e-5 * f);
      EXPECT_NEAR(near->pole.damping, f < 200.0 ? 1.43e-4 : 1.14e-4, 0.2e-4);
    }
    EXPECT_EQ(found.modes_inside(), expected) << range[0] << ":" << range[1];
  }
}

TEST_F(MeasuredModes, SisoFrf) {
  if (!frf::has_matio()) JOINTID_SKIP("this build lacks matio");
  const auto path = file("siso-coherence/case1.mat");
  if (!std::filesystem::exists(path)) JOINTID_SKIP(path << " is missing: no external data");
  const frf::Dof dof = frf::Dof::parse("1:+Z");
  frf::OpenOptions options;
  options.quantity = frf::Quantity::accelerance;
  options.response = options.reference = {dof};
  options.variable = "Hf_chan_2";
  const frf::FrfSet set = frf::load(*frf::open(path, options));
  for (const std::array range : {std::array{190.0, 235.0}, std::array{100.0, 300.0}}) {
    Band band = make_band(set, range);
    const ModalFit found = fit(band, set.header, {});
    const auto mode = std::ranges::find_if(found.modes, [](const Mode& each) { return std::abs(each.pole.frequency_hz - 212.09) < 0.1; });
    ASSERT_NE(mode, found.modes.end());
    EXPECT_NEAR(mode->pole.damping, 0.00087, 0.0002);
  }
}

}  // namespace
}  // namespace jointid::modalfit
