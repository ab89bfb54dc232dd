#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/error.hpp"
#include "tasks/oscillate/oscillate_scene.hpp"
#include "tasks/oscillate/run_oscillate.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

/// Keys of scenes for the rig of Kappagantu's thesis: tilt, A(f), normal vibrations, a thick beam.
namespace jointid::tasks {
namespace {

struct Keys {
  std::string system = "amplitude = 0.0023\nfrequency = 12.0\n", friction, more;
};

std::string beam(const Keys& keys) {
  return "[system]\nkind = \"cantilever\"\nmodes = 3\nmodal_damping = 0.02\n" + keys.system +
         "[friction]\nkinetic = 0.55\nstatic = 0.75\nnormal = 0.345\ncontact_stiffness = 20000.0\n" + keys.friction +
         "[motion]\ntransient = 0.5\nlength = 0.5\nstep = 0.002\n" + keys.more;
}

OscillateScene scene_of(const Keys& keys) { return parse_oscillate_scene(beam(keys), "beam.toml"); }

std::string error_of(const Keys& keys) {
  try {
    (void)scene_of(keys);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ContactDetails, AmplitudeIsATableOverTheFrequency) {
  const nlohmann::json golden = golden_case("seeds.json", "name", "kappagantu_small");
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  const nlohmann::json& table = golden["expected"]["amplitude_table"];
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < table["hz"].size(); ++i) rows.push_back({table["hz"][i], table["amplitude"][i]});
  SystemSpec spec =
      scene_of({.system = "amplitude = " + rows.dump() + "\nfrequency = 12.0\n", .friction = {}, .more = {}}).system;
  for (std::size_t i = 0; i < table["at_hz"].size(); ++i) {
    set_swept(spec, "frequency", table["at_hz"][i]);
    EXPECT_NEAR(model_of(spec).drive.amplitude, table["value"][i].get<double>(), 1e-15);
  }
}

TEST(ContactDetails, ATiltMakesTheMotionLopsided) {
  const OscillateResult level = run_oscillate(scene_of({}));
  const OscillateResult tilted = run_oscillate(scene_of({.system = Keys{}.system, .friction = "tilt = 5.0\n", .more = {}}));
  const auto extremes = [](const OscillateResult& run) {
    for (std::size_t c = 0; c < run.motion->columns.size(); ++c) {
      if (run.motion->columns[c].name != "friction") continue;
      const auto column = run.motion->samples.col(static_cast<Eigen::Index>(c));
      return std::pair(column.maxCoeff(), column.minCoeff());
    }
    return std::pair(0.0, 0.0);
  };
  const auto [up, down] = extremes(level);
  const auto [more, less] = extremes(tilted);
  EXPECT_GT(more, 1.1 * up);
  EXPECT_GT(less, down);
}

TEST(ContactDetails, NormalVibrationsAndThickBeamAreOfTheResult) {
  const std::string normal =
      "[normal_vibrations]\nmass = 0.01551\nstiffness = 901.77536\nextension_stiffness = 282.774023437\nslope = -0.00545\n"
      "offset = 0.00122\nfrequencies = [5.0, 41.1]\n";
  const OscillateResult found =
      run_oscillate(scene_of({.system = Keys{}.system + "poisson_ratio = 0.34\n", .friction = {}, .more = normal}));
  ASSERT_TRUE(found.normal_vibrations);
  ASSERT_EQ(found.normal_vibrations->motions.size(), 2u);
  EXPECT_NEAR(found.normal_vibrations->motions[0].force, 0.262630121991, 1e-11);
  EXPECT_NEAR(found.normal_vibrations->motions[0].force_first.real(), -0.00268734, 2e-6);  // without damping
  EXPECT_GT(found.normal_vibrations->motions[1].force_first.real(), 0.0);                  // beyond the resonance
  ASSERT_EQ(found.thick_modes.size(), 3u);
  EXPECT_LT(found.thick_modes[2].timoshenko_hz, found.thick_modes[2].euler_hz);
  EXPECT_TRUE(run_oscillate(scene_of({})).thick_modes.empty());
}

TEST(ContactDetails, MistakesAreErrorsWithRemedies) {
  using testing::HasSubstr;
  const std::string drive = Keys{}.system;
  EXPECT_THAT(error_of({drive, "tilt = 40.0\n", ""}), HasSubstr("slide by its load alone"));
  EXPECT_THAT(error_of({"amplitude = [[12.0, 0.002], [5.0, 0.001]]\nfrequency = 8.0\n", "", ""}), HasSubstr("sort the rows"));
  EXPECT_THAT(error_of({"amplitude = [12.0, 0.002]\nfrequency = 8.0\n", "", ""}), HasSubstr("[12.0, 0.0023]"));
  const std::string sweep = "[sweep]\nparameter = \"amplitude\"\nrange = [0.001, 0.002]\npoints = 2\nlength = 10.0\n";
  EXPECT_THAT(error_of({"amplitude = [[5.0, 0.002], [12.0, 0.001]]\nfrequency = 8.0\n", "", sweep}),
              HasSubstr("sweep frequency"));
  EXPECT_THAT(error_of({drive + "poisson_ratio = 30.0\n", "", ""}), HasSubstr("above 0.5"));
  EXPECT_THAT(
      error_of({"velocity = 0.2\n", "",
                "[normal_vibrations]\nmass = 0.01\nstiffness = 1.0\nextension_stiffness = 1.0\nslope = 0.1\noffset = 0.1\n"}),
      HasSubstr("no slider"));
  EXPECT_THAT(error_of({drive, "", "[normal_vibrations]\nmas = 0.01\n"}), HasSubstr("mass"));
}

}  // namespace
}  // namespace jointid::tasks
