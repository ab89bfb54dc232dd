// Runs that were interrupted go on from their finished levels.
#include "tasks/response/level_state.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

/// Stability and loops of matrices; dropped harmonics and deviations of files.
ResponseScene chain_scene() {
  const std::string levels = replaced(rest, "amplitudes = [1.0, 3.0]", "amplitudes = [0.5, 1.0, 2.0, 3.0]");
  return parse_response_scene(chain + replaced(replaced(levels, "points = 41", "points = 11"), "[response]", "[response]\nstability = true"),
                              "scene.toml");
}

/// Ends before point `point` of the level after `finished` ones; what was kept then.
std::string interrupted_at(const ResponseScene& scene, std::size_t finished, std::size_t point, LevelsSoFar before = {}) {
  std::string state;
  bool ends = false;
  ident::Control control;
  control.interrupted = [&] { return ends; };
  const KeepLevels keep = [&](const auto& levels, const auto& begun) {
    ends = levels.size() == finished && begun.size() == point;
    if (ends) state = packed_levels({levels, begun});
  };
  EXPECT_THROW(run_response(scene, control, std::move(before), keep), Interrupted);
  return state;
}

std::string whole(const ResponseScene& scene, LevelsSoFar before = {}) {
  return packed_levels({run_response(scene, {}, std::move(before)).levels, {}});
}

void goes_on_to_the_same(const ResponseScene& scene) {
  const std::string in_one_run = whole(scene);
  LevelsSoFar before;
  for (std::size_t finished = 0; finished < scene.levels.size(); ++finished) {
    for (const std::size_t point : {std::size_t{0}, std::size_t{4}}) {
      const auto state = unpacked_levels(interrupted_at(scene, finished, point, before));
      ASSERT_TRUE(state);
      ASSERT_EQ(state->finished.size(), finished);
      ASSERT_EQ(state->begun.size(), point);
      before = *state;
      EXPECT_TRUE(whole(scene, before) == in_one_run) << finished << " levels, " << point << " points";
    }
  }
}

TEST(LevelState, InterruptedInAnyLevelTheRunEndsWithTheSameBits) { goes_on_to_the_same(chain_scene()); }

TEST(LevelState, SoDoRunsOnFilesOfParts) {
  const TestFolder folder;
  write_parts(folder);
  const std::string text = replaced(parts_scene("range = [1.0, 3.0]\n", "[1, 3, 5, 21]"), "amplitudes = [8.0]", "amplitudes = [2.0, 8.0]");
  goes_on_to_the_same(parse_response_scene(text, folder / "scene.toml"));
}

TEST(LevelState, BytesThatAreCutShortOrLongerAreNone) {
  const std::string state = whole(chain_scene());
  for (std::size_t bytes = 0; bytes < state.size(); bytes += 1 + state.size() / 997) EXPECT_FALSE(unpacked_levels(state.substr(0, bytes))) << bytes;
  EXPECT_FALSE(unpacked_levels(state + '\0'));
  EXPECT_TRUE(unpacked_levels(state));
}

}  // namespace
}  // namespace jointid::tasks
