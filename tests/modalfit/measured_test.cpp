#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "frf/frf_source.hpp"
#include "modalfit/fit.hpp"
#include "modalfit/synthesis.hpp"

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
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing: no external data";
  const frf::FrfSet set = frf::load(*frf::open(path));
  Band band = make_band(set, {});
  const ModalFit found = fit(band, set.header, {});
  EXPECT_EQ(found.status, FitStatus::ok) << found.message;
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

/// The first lines tell the noise of the others nothing; without them the fit has to find another one, and be weighted by it.
TEST_F(MeasuredModes, TheNoiseOfTheWeightsIsTheNoiseThatIsLeft) {
  const auto path = file("uff/measurement.uff");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing: no external data";
  const frf::FrfSet set = frf::load(*frf::open(path));
  for (const double low : {5.0, 20.0}) {
    Band band = make_band(set, std::array{low, 1000.0});
    const ModalFit found = fit(band, set.header, {});
    EXPECT_NEAR(found.cost / found.freedom, 1.0, 0.06) << low;
    EXPECT_TRUE(std::ranges::any_of(found.modes, [](const Mode& mode) { return std::abs(mode.pole.frequency_hz - 900.87) < 0.1; })) << low;
    EXPECT_EQ(found.modes_inside(), 7u) << low;
  }
}

TEST_F(MeasuredModes, SisoFrf) {
#if JOINTID_HAVE_MATIO
  const auto path = file("siso-coherence/case1.mat");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing: no external data";
  const frf::Dof dof = frf::Dof::parse("1:+Z");
  const frf::FrfSet set = frf::load(
      *frf::open(path, {.quantity = frf::Quantity::accelerance, .response = {dof}, .reference = {dof}, .variable = "Hf_chan_2"}));
  for (const std::array range : {std::array{190.0, 235.0}, std::array{100.0, 300.0}}) {
    Band band = make_band(set, range);
    const ModalFit found = fit(band, set.header, {});
    const auto mode = std::ranges::find_if(found.modes, [](const Mode& each) { return std::abs(each.pole.frequency_hz - 212.09) < 0.1; });
    ASSERT_NE(mode, found.modes.end());
    EXPECT_NEAR(mode->pole.damping, 0.00087, 0.0002);
  }
#else
  GTEST_SKIP() << "this build lacks matio";
#endif
}

}  // namespace
}  // namespace jointid::modalfit
