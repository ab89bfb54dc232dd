// The check of scenes of a few lines: FRFs of virtual points, whose error at a resonance is larger than their own size says.
#include <gmock/gmock.h>

#include <algorithm>

#include "ident/check/test/file_tests.hpp"
#include "ident/check/test/slope_fit.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
using ident::SuspectKind;

ident::CheckResult checked(const char* name, std::uint64_t seed, double step_hz) {
  const TestFolder folder;
  ident::Scene scene = ident::read_scene(problems::write(problems::make(name), folder, {.seed = seed}));
  scene.frequency.step_hz = step_hz;
  return ident::check_whole(scene);
}

TEST(FewLines, OfVirtualPointsHaveNoFalseOutlier) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const ident::CheckResult result = checked("flange", seed, 400.0);
    for (const ident::Suspect& suspect : result.suspects) {
      EXPECT_NE(suspect.kind, SuspectKind::outlier) << seed << ": " << suspect.evidence;
      EXPECT_NE(suspect.kind, SuspectKind::not_reciprocal) << seed << ": " << suspect.evidence;
    }
  }
}

/// Seven and four lines.
TEST(FewLines, NameNoGainThatIsNotThere) {
  for (const double step_hz : {400.0, 800.0}) {
    const ident::CheckResult result = checked("flange", 2, step_hz);
    for (const ident::Suspect& suspect : result.suspects) {
      EXPECT_NE(suspect.kind, SuspectKind::gain) << step_hz << ": " << suspect.evidence;
    }
  }
}

/// Quantiles of Student's t: 5.959 of six degrees of freedom, 31.60 of two at 0.1 % on both sides; 4.417 of the normal law at 10⁻⁵.
TEST(Significance, IsThatOfStudentsLawAndOfAllThatWereTried) {
  EXPECT_TRUE(ident::may_be_chance(5.95, 6.0, 1.0));
  EXPECT_FALSE(ident::may_be_chance(-5.97, 6.0, 1.0));
  EXPECT_TRUE(ident::may_be_chance(31.5, 2.0, 1.0));
  EXPECT_FALSE(ident::may_be_chance(31.7, 2.0, 1.0));
  EXPECT_TRUE(ident::may_be_chance(4.41, 1e7, 100.0));
  EXPECT_FALSE(ident::may_be_chance(4.42, 1e7, 100.0));
  EXPECT_TRUE(ident::may_be_chance(1e9, 0.5, 1.0));
}

TEST(SlopeFit, HasTheFreedomOfTheLinesThatTell) {
  ident::SlopeFit even, one;
  for (std::size_t line = 0; line < 8; ++line) {
    even.add(1.0, 2.0);
    one.add(1.0, line == 0 ? 1e6 : 1.0);
  }
  EXPECT_NEAR(even.freedom(), 7.0, 1e-12);
  EXPECT_NEAR(one.freedom(), 0.0, 1e-4);
}

TEST(FewLines, NameATurnedSensorFirst) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ident::CheckResult result = checked("flange-turned", seed, 400.0);
    ASSERT_FALSE(result.suspects.empty());
    EXPECT_EQ(result.suspects.front().kind, SuspectKind::direction) << seed << ": " << result.suspects.front().evidence;
  }
}

}  // namespace
