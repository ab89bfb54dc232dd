// The check of scenes of a few lines: FRFs of virtual points, whose error at a resonance is larger than their own size says.
#include <gmock/gmock.h>

#include <algorithm>

#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
using ident::SuspectKind;

ident::CheckResult checked_at_seven_lines(const char* name, std::uint64_t seed) {
  const TestFolder folder;
  ident::Scene scene = ident::read_scene(problems::write(problems::make(name), folder, {.seed = seed}));
  scene.frequency.step_hz = 400.0;
  return ident::check_whole(scene);
}

TEST(FewLines, OfVirtualPointsHaveNoFalseOutlier) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const ident::CheckResult result = checked_at_seven_lines("flange", seed);
    for (const ident::Suspect& suspect : result.suspects) {
      EXPECT_NE(suspect.kind, SuspectKind::outlier) << seed << ": " << suspect.evidence;
      EXPECT_NE(suspect.kind, SuspectKind::not_reciprocal) << seed << ": " << suspect.evidence;
    }
  }
}

TEST(FewLines, NameATurnedSensorFirst) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ident::CheckResult result = checked_at_seven_lines("flange-turned", seed);
    ASSERT_FALSE(result.suspects.empty());
    EXPECT_EQ(result.suspects.front().kind, SuspectKind::direction) << seed << ": " << result.suspects.front().evidence;
  }
}

}  // namespace
