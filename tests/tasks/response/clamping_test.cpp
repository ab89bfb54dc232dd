// [clamping] of `jointid response`: the normal load of the least peak.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/response/response_page.hpp"
#include "report/response/response_text.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Two masses coupled by a slider; the first resonance of the free second mass is damped by it.
std::string slider(double limit, const std::string& levels = "[1.0]") {
  return R"(
[structure]
mass = [[1.0, 0.0], [0.0, 0.5]]
stiffness = [[1.0e4, 0.0], [0.0, 2.0e4]]
damping = [[1.0, 0.0], [0.0, 1.0]]

[[joints]]
name = "bolt"
dofs = [1, 2]
law = "bilinear"
parameters = { k = 1.0e4, a = )" +
         fmt::format("{}", 1e-4 * limit) + R"( }

[force]
dof = 1
amplitudes = )" +
         levels + R"(

[frequency]
range = [10.0, 30.0]
points = 61

[response]
dofs = [1]
harmonics = [1, 3]
)";
}

double peak_of(const std::string& text, std::size_t level = 0) {
  const LevelResponse found = run_response(parse_response_scene(text, "scene.toml")).levels.at(level);
  return std::abs(found.peak->response(0, 0));
}

ClampingRun clamping_of(const std::string& text, std::size_t level = 0) {
  return run_response(parse_response_scene(text, "scene.toml")).clampings.at(level);
}

TEST(Clamping, FindsTheLoadOfTheLeastPeak) {
  const ClampingRun run = clamping_of(slider(1.0) + "\n[clamping]\nrange = [0.02, 50.0]\n");
  ASSERT_TRUE(run.best);
  EXPECT_FALSE(run.at_end);
  // No neighbour on a fine grid of slip limits, each a scene of its own, is lower.
  double least = run.peaks.front().amplitude.value();
  for (double load = 0.02; load < 50.0; load *= 1.1) least = std::min(least, peak_of(slider(load)));
  EXPECT_LT(*run.best->amplitude, least * (1.0 + 1e-4));
  EXPECT_GT(*run.best->amplitude, 0.99 * least);
  EXPECT_LT(*run.best->amplitude, 0.5 * *run.peaks.front().amplitude);
  EXPECT_LT(*run.best->amplitude, 0.9 * *run.peaks.back().amplitude);
  EXPECT_NEAR(*run.best->amplitude, peak_of(slider(run.best->load)), 1e-6 * *run.best->amplitude);
}

TEST(Clamping, AmplitudeStaysWithinATenthBetweenTheLoadsNamed) {
  const ClampingRun run = clamping_of(slider(1.0) + "\n[clamping]\nrange = [0.02, 50.0]\npoints = 25\n");
  const auto [from, to] = run.within_tenth;
  EXPECT_LT(from, run.best->load);
  EXPECT_GT(to, run.best->load);
  EXPECT_NEAR(peak_of(slider(from)), 1.1 * *run.best->amplitude, 0.03 * *run.best->amplitude);
  EXPECT_NEAR(peak_of(slider(to)), 1.1 * *run.best->amplitude, 0.03 * *run.best->amplitude);
}

// With all friction clamped alike X(λ, F) = λ X(1, F/λ): the best load grows with the force.
TEST(Clamping, BestLoadIsInProportionToTheForce) {
  const std::string text = slider(1.0, "[1.0, 4.0]") + "\n[clamping]\nrange = [0.02, 80.0]\n";
  const ResponseResult run = run_response(parse_response_scene(text, "scene.toml"));
  ASSERT_EQ(run.clampings.size(), 2u);
  EXPECT_NEAR(run.clampings[1].best->load / run.clampings[0].best->load, 4.0, 0.2);
  EXPECT_NEAR(*run.clampings[1].best->amplitude / *run.clampings[0].best->amplitude, 4.0, 1e-3);
}

TEST(Clamping, IsToldEverywhere) {
  const ResponseScene scene =
      parse_response_scene(slider(1.0) + "\n[clamping]\njoints = [\"bolt\"]\nrange = [0.02, 50.0]\nnominal = 200.0\n", "scene.toml");
  const ResponseResult run = run_response(scene);
  const ClampingRun& clamping = run.clampings.front();
  const std::string text = report::response_text(scene, run);
  EXPECT_THAT(text, testing::AllOf(HasSubstr("peak over the normal load"), HasSubstr("the peak is least under")));
  EXPECT_THAT(report::response_report(scene, run), HasSubstr("Clamping force"));
  const json out = json::parse(report::response_json(scene, run))["clamping"][0];
  EXPECT_EQ(out["peaks"].size(), clamping.peaks.size());
  EXPECT_DOUBLE_EQ(out["best"]["load"].get<double>(), clamping.best->load);
  EXPECT_EQ(out["nominal"], 200.0);
  EXPECT_TRUE(all_converged(run));
}

TEST(Clamping, SaysThatTheLeastLiesBeyondTheRange) {
  const ResponseScene scene = parse_response_scene(slider(1.0) + "\n[clamping]\nrange = [0.001, 0.1]\n", "scene.toml");
  const ResponseResult run = run_response(scene);
  EXPECT_TRUE(run.clampings.front().at_end);
  EXPECT_THAT(report::response_text(scene, run), HasSubstr("Widen range"));
}

TEST(Clamping, RefusesWhatNoLoadChanges) {
  EXPECT_THAT(error_of(slider(1.0) + "\n[clamping]\nrange = [0.0, 1.0]\n"), HasSubstr("begin above it"));
  EXPECT_THAT(error_of(slider(1.0) + "\n[clamping]\njoints = [2]\nrange = [0.1, 1.0]\n"), HasSubstr("is not a whole number from 1 to 1"));
  EXPECT_THAT(error_of(slider(1.0) + "\n[clamping]\njoints = [1, \"bolt\"]\nrange = [0.1, 1.0]\n"), HasSubstr("named twice"));
  EXPECT_THAT(error_of(replaced(slider(1.0), "law = \"bilinear\"\nparameters = { k = 1.0e4, a = 0.0001 }", "stiffness = 5.0") +
                       "\n[clamping]\nrange = [0.1, 1.0]\n"),
              HasSubstr("no joint has a friction law"));
  EXPECT_THAT(error_of(slider(1.0) + "\n[clamping]\nrnage = [0.1, 1.0]\n"), HasSubstr("rnage"));
}

}  // namespace
}  // namespace jointid::tasks
