#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "base/error.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "scene/kind.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

const std::string good = R"(
[data]
parts = ["a.h5", "b.h5"]

[[data.levels]]
responses = ["l1.h5", "l1_3.h5"]
forces = ["f1.h5", "f1_3.h5"]
force_dofs = ["1:+Y"]
harmonics = [1, 3]

[[data.levels]]
name = "high"
responses = "l2.h5"
amplitude = 12.5
force_dofs = ["1:+Y"]
per_force = true

[data.files."l2.h5"]
quantity = "accelerance"

[frequency]
range = [10.0, 20.0]

[errors]
relative = 0.01

[[joint.friction]]
name = "left"
dofs = ["2:+Y", "12:+Y"]
law = ["ren", "iwan"]
stiffness = 1e4
unknown = ["stiffness", "damping"]
bounds = { k = [1e5, 1e8] }
priors = { k = [1e6, 1e5] }

[[joint.friction]]
dofs = ["5:+Y"]
same_as = "left"
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
}

std::string error_of(const std::string& text) {
  try {
    parse_law_scene(text, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(LawScene, ReadsAllThatItSays) {
  ASSERT_TRUE(scene::is_law_scene(good, "scene.toml"));
  const LawScene scene = parse_law_scene(good, "folder/scene.toml");
  ASSERT_EQ(scene.levels.size(), 2u);
  EXPECT_EQ(scene.levels[0].harmonics[1].harmonic, 3);
  EXPECT_EQ(scene.levels[0].harmonics[1].forces->path, ident::Path("folder/f1_3.h5"));
  EXPECT_EQ(scene.levels[1].amplitude, 12.5);
  EXPECT_TRUE(scene.levels[1].per_force);
  EXPECT_EQ(scene.levels[1].harmonics[0].responses.options.quantity, frf::Quantity::accelerance);
  ASSERT_EQ(scene.joints.size(), 2u);
  EXPECT_EQ(scene.joints[0].laws, (std::vector<std::string>{"ren", "iwan"}));
  EXPECT_EQ(scene.joints[1].laws, scene.joints[0].laws);
  EXPECT_EQ(scene.joints[1].beside.name, "5:+Y–ground");
  EXPECT_EQ(scene.constraints.leader(1), 0u);
  EXPECT_EQ(scene.constraints.beside[0], (std::vector<std::string>{"stiffness", "damping"}));
  ASSERT_EQ(scene.constraints.rules.size(), 2u);
  EXPECT_EQ((*scene.constraints.rules[1].prior)[1], 1e5);
  EXPECT_EQ(files_of(scene).size(), 1u + 2u + 5u);
}

TEST(LawScene, SaysInOneLineWhatIsWrong) {
  const std::vector<std::array<std::string, 3>> wrong = {
      {"law = [\"ren\", \"iwan\"]", "law = \"rem\"", "rem"},
      {"law = [\"ren\", \"iwan\"]", "law = [\"ren\", \"ren\"]", "named twice"},
      {"dofs = [\"2:+Y\", \"12:+Y\"]", "dofs = [\"2:+Y\", \"12:+Y\", \"3:+Y\"]", "one end or two"},
      {"same_as = \"left\"", "same_as = \"lift\"", "did you mean left?"},
      {"same_as = \"left\"", "same_as = \"left\"\nlaw = \"ren\"", "both law and same_as"},
      {"same_as = \"left\"", "same_as = \"left\"\npriors = { k = [1.0, 1.0] }", "has the law of left"},
      {"bounds = { k", "bounds = { kk", "'kk' is not known here"},
      {"unknown = [\"stiffness\", \"damping\"]", "unknown = [\"mass\"]", "mass"},
      {"unknown = [\"stiffness\", \"damping\"]", "unknown = [\"cubic\"]", "where does the cubic spring begin?"},
      {"harmonics = [1, 3]", "harmonics = [3, 1]", "do not ascend"},
      {"harmonics = [1, 3]", "harmonics = [1, 3]\namplitudes = \"RMS\"", "rms"},
      {"harmonics = [1, 3]", "harmonics = [1, 3, 5]", "2 files for 3 harmonics"},
      {"harmonics = [1, 3]", "harmonics = [1.5, 3]", "1.5 is not a whole number"},
      {"amplitude = 12.5\n", "", "the force is not given"},
      {"amplitude = 12.5", "amplitude = 12.5\nforces = \"f2.h5\"", "both forces and amplitude"},
      {"amplitude = 12.5\nforce_dofs = [\"1:+Y\"]", "amplitude = 12.5\nforce_dofs = [\"1:+Y\", \"2:+Y\"]", "several force DOFs"},
      {"relative = 0.01", "relative = 0.0", "no phasor has an error"},
      {"range = [10.0, 20.0]", "exclude_resonances = { of = [\"assembly\"] }", "friction shows at resonances"},
      {"[data]\n", "[data]\nassembly = [\"c.h5\"]\n", "assembly"},
  };
  for (const auto& [what, by, expected] : wrong) {
    const std::string error = error_of(replaced(good, what, by));
    EXPECT_THAT(error, HasSubstr(expected)) << by;
    EXPECT_THAT(error, HasSubstr("scene.toml")) << by;
  }
}

TEST(LawScene, OneFileOfSeveralHarmonicsNeedsTheRange) {
  const std::string one =
      replaced(replaced(good, "[\"l1.h5\", \"l1_3.h5\"]", "\"l1.h5\""), "[\"f1.h5\", \"f1_3.h5\"]", "\"f1.h5\"");
  EXPECT_EQ(parse_law_scene(one, "scene.toml").levels[0].harmonics[1].responses.path, ident::Path("l1.h5"));
  EXPECT_THAT(error_of(replaced(one, "range = [10.0, 20.0]", "")), HasSubstr("give [frequency] range"));
}

TEST(LawScene, LinearScenesAreNone) { EXPECT_FALSE(scene::is_law_scene("[joint]\ndofs = [\"1:+X\"]\n", "scene.toml")); }

}  // namespace
}  // namespace jointid::laws
