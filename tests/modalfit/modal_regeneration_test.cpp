#include "ident/modal_regeneration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"
#include "study/comparison.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::ident {
namespace {

using testing::HasSubstr;

std::string scene_text(const std::string& data) {
  return "[data]\nsubstructures = [\"a.h5\"]\nassembly = [\"b.h5\"]\n" + data +
         "\n[joint]\ndofs = [\"1:+Z\", \"2:+Z\"]\n[joint.stiffness]\npattern = \"symmetric\"\n";
}

std::string error_of(const std::string& data) {
  try {
    parse_scene(scene_text(data), "a.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ModalRegeneration, TheSceneNamesTheSystems) {
  EXPECT_FALSE(parse_scene(scene_text(""), "a.toml").data.regenerate.any());
  const Scene one = parse_scene(scene_text("regenerate = [\"substructures\"]"), "a.toml");
  EXPECT_EQ(one.data.regenerate, (Regeneration{true, false}));
  const Scene both = parse_scene(scene_text("regenerate = [\"assembly\", \"substructures\"]"), "a.toml");
  EXPECT_EQ(both.data.regenerate, (Regeneration{true, true}));
  EXPECT_THAT(error_of("regenerate = [\"substructure\"]"), testing::AllOf(HasSubstr("line 4"), HasSubstr("did you mean substructures")));
  EXPECT_THAT(error_of("regenerate = \"assembly\""), HasSubstr("regenerate"));
}

TEST(ModalRegeneration, NamesComeBack) {
  for (const Regeneration& each : {Regeneration{}, Regeneration{true, false}, Regeneration{false, true}, Regeneration{true, true}}) {
    EXPECT_EQ(parse_regeneration(name(each)), each);
  }
}

TEST(ModalRegeneration, IsAnAlternativeToCompare) {
  study::Alternatives lists;
  lists.regenerations = {{}, {true, false}};
  lists.deltas = {0.0, 0.1};
  const auto ways = study::combinations({}, lists);
  ASSERT_EQ(ways.size(), 4u);
  EXPECT_FALSE(ways[1].regenerate.any());
  EXPECT_TRUE(ways[2].regenerate.substructures);
  EXPECT_TRUE(study::combinations({}, {}, {false, true}).front().regenerate.assembly);
}

/// The FRFs handed out are nearer to the exact ones than those measured, and their variances say how near.
TEST(ModalRegeneration, SourcesHandOutTheModelsFrfs) {
  const auto exact = problems::make_modal_set("modes-pair");
  const frf::FrfSet noisy = problems::polluted(exact, 1, 0);
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(frf::from_memory(noisy));
  Scene scene;
  scene.frequency.range_hz = Range{92.0, 109.0};
  std::vector<ModalRegeneration> told;
  const auto made = regenerate_sources(std::move(sources), false, scene, told);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].modes, 2u);
  EXPECT_EQ(told[0].harm, "");
  const frf::FrfSet set = frf::load(*made.front());
  double before = 0.0, after = 0.0, predicted = 0.0;
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const double f = set.header.frequency_hz[i / set.header.entries()];
    if (f < 90.3 || f > 110.7) {
      EXPECT_TRUE(std::isnan(set.values[i].real()));
    } else if (f > 92.0 && f < 109.0) {
      before += std::norm(noisy.values[i] - exact.clean.values[i]);
      after += std::norm(set.values[i] - exact.clean.values[i]);
      predicted += set.variance[i].real() + set.variance[i].imag();
    }
  }
  EXPECT_LT(after, 0.02 * before);
  EXPECT_GT(predicted, 0.1 * after);
  EXPECT_LT(predicted, 10.0 * after);
}

/// FRFs that no sum of modes can be: the warning, and its place in the note.
TEST(ModalRegeneration, TellsWhereTheModelHarms) {
  frf::FrfSet set = problems::polluted(problems::make_modal_set("modes-pair"), 1, 0);
  for (std::size_t i = 0; i < set.values.size(); ++i) set.values[i] *= 1.0 + 0.3 * std::sin(0.02 * static_cast<double>(i));
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(frf::from_memory(std::move(set)));
  std::vector<ModalRegeneration> told;
  regenerate_sources(std::move(sources), false, Scene{}, told);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].harm, "");
  EXPECT_THAT(note(told[0]), HasSubstr("worse than the measured ones"));
}

}  // namespace
}  // namespace jointid::ident
