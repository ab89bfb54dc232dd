#include "ident/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "by_case.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/case/in_memory.hpp"

namespace jointid::problems {
namespace {

class EveryScene : public ByCase {};

bool excluded(const ident::Scene& scene, double frequency_hz) {
  return std::any_of(
      scene.frequency.exclude_hz.begin(), scene.frequency.exclude_hz.end(),
      [&](const auto& interval) { return interval[0] <= frequency_hz && frequency_hz <= interval[1]; });
}

TEST_P(EveryScene, SaysWhatTheCaseSays) {
  const Problem problem = build(definition_);
  const ident::Scene scene = ident::parse_scene(problem.scene, "folder/" + problem.name + ".toml");
  ASSERT_EQ(scene.data.substructures.size(), problem.substructures.size());
  for (std::size_t i = 0; i < problem.substructures.size(); ++i) {
    EXPECT_EQ(scene.data.substructures[i].path.filename(), problem.substructures[i].header.file);
  }
  ASSERT_EQ(scene.joints.size(), 1U);
  EXPECT_EQ(scene.joints[0].dofs, problem.joint_dofs);
  EXPECT_EQ(scene.joints[0].matrices.size(), definition_.joint.size());
  EXPECT_EQ(scene.truth, problem.truth);
  EXPECT_EQ(ident::name(scene.identify.method), definition_.method);
  EXPECT_EQ(scene.identify.equations.size(), definition_.equations.size());
  EXPECT_EQ(scene.identify.delta, definition_.delta);
  EXPECT_EQ(scene.noise.has_value(), !definition_.hammer.has_value());
}

/// Of the lines in the file, all lie in the range; those left out are the ones at natural frequencies, and
/// not many.
TEST_P(EveryScene, UsesTheLinesOfTheCase) {
  const Problem problem = build(definition_);
  const ident::Scene scene = ident::parse_scene(problem.scene, "scene.toml");
  const std::vector<double>& axis = problem.assembly.header.frequency_hz;
  EXPECT_EQ(scene.frequency.range_hz, (ident::Range{axis.front(), axis.back()}));
  std::size_t left_out = 0;
  for (const double f : axis) {
    const auto near = [&](const Modes& all) {
      return std::any_of(all.frequency_hz.begin(), all.frequency_hz.end(),
                         [&](double resonance) { return std::abs(f - resonance) <= 0.01 * resonance; });
    };
    const bool resonant = near(problem.assembly_modes) || std::any_of(problem.substructure_modes.begin(),
                                                                      problem.substructure_modes.end(), near);
    EXPECT_EQ(excluded(scene, f), resonant && definition_.exclude_resonances) << f;
    left_out += excluded(scene, f) ? 1U : 0U;
  }
  EXPECT_EQ(left_out > 0, definition_.exclude_resonances);
  EXPECT_LE(left_out, axis.size() / 5);
  EXPECT_THAT(plan(scene, {problem.substructures, problem.assembly})->warnings, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(ByCase::all()), ByCase::name_of);

}  // namespace
}  // namespace jointid::problems
