// Runs that were interrupted go on from their finished levels.
#include "tasks/response/level_state.hpp"

#include <gtest/gtest.h>

#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

/// Stability and loops of matrices; dropped harmonics and deviations of files.
ResponseScene chain_scene() {
  const std::string levels = replaced(rest, "amplitudes = [1.0, 3.0]", "amplitudes = [0.5, 1.0, 2.0, 3.0]");
  return parse_response_scene(chain + replaced(levels, "points = 41", "points = 11\nstability = true"), "scene.toml");
}

/// Ends in the level after `finished` ones; what was told of those.
std::string interrupted_after(const ResponseScene& scene, std::size_t finished, std::vector<LevelResponse> before = {}) {
  std::string state;
  bool ends = finished == before.size();
  ident::Control control;
  control.interrupted = [&] { return ends; };
  const FinishedLevels kept{.before = std::move(before), .finished = [&](const std::vector<LevelResponse>& levels) {
                              state = packed_levels(levels);
                              ends = levels.size() == finished;
                            }};
  EXPECT_THROW(run_response(scene, control, kept), Interrupted);
  return state;
}

void goes_on_to_the_same(const ResponseScene& scene) {
  const std::string whole = packed_levels(run_response(scene).levels);
  std::string state;
  for (std::size_t finished = 1; finished < scene.levels.size(); ++finished) {
    const auto before = finished == 1 ? std::vector<LevelResponse>{} : *unpacked_levels(state);
    state = interrupted_after(scene, finished, before);
    const auto levels = unpacked_levels(state);
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->size(), finished);
    const FinishedLevels kept{.before = *levels, .finished = {}};
    EXPECT_TRUE(packed_levels(run_response(scene, {}, kept).levels) == whole) << finished;
  }
}

TEST(LevelState, InterruptedAfterAnyLevelTheRunEndsWithTheSameBits) { goes_on_to_the_same(chain_scene()); }

TEST(LevelState, SoDoRunsOnFilesOfParts) {
  const TestFolder folder;
  write_parts(folder);
  const std::string text = replaced(parts_scene("range = [1.0, 3.0]\n", "[1, 3, 5, 21]"), "amplitudes = [8.0]", "amplitudes = [2.0, 8.0]");
  goes_on_to_the_same(parse_response_scene(text, folder / "scene.toml"));
}

TEST(LevelState, BytesThatAreCutShortOrLongerAreNone) {
  const std::string state = packed_levels(run_response(chain_scene()).levels);
  for (std::size_t bytes = 0; bytes < state.size(); bytes += 1 + state.size() / 997) EXPECT_FALSE(unpacked_levels(state.substr(0, bytes))) << bytes;
  EXPECT_FALSE(unpacked_levels(state + '\0'));
  EXPECT_TRUE(unpacked_levels(state));
}

}  // namespace
}  // namespace jointid::tasks
