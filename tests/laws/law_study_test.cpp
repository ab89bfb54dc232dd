#include "laws/task/law_study.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "base/control.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/law_comparison.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

/// Planned levels of a bilinear joint on the mass of sdof-iwan, whose FRFs have 1 % of noise.
class LawStudyScene : public testing::Test {
 protected:
  LawStudyScene() {
    problems::write(problems::make_law_problem("sdof-iwan"), folder_, {});
    scene_ = parse_law_scene(R"([data]
parts = ["sdof-iwan_part_1.h5"]
[[data.levels]]
amplitude = 4.0
force_dofs = ["1:+Y"]
harmonics = [1, 3]
[[data.levels]]
amplitude = 20.0
force_dofs = ["1:+Y"]
harmonics = [1, 3]
[[joint.friction]]
name = "slot"
dofs = ["1:+Y"]
law = "bilinear"
assumed = { a = 1e-5, k = 4e5 }
[frequency]
range = [80.0, 135.0]
[errors]
relative = 0.01
[identify]
harmonics = [1, 3]
)",
                             folder_ / "plan.toml");
  }

  TestFolder folder_;
  LawScene scene_;
};

TEST_F(LawStudyScene, ErrorsAreThoseOfTheBound) {
  constexpr std::size_t trials = 60;
  const LawStudy study = study_laws(scene_, {.trials = trials, .seed = 3, .threads = 2});
  EXPECT_TRUE(study.assumed);
  EXPECT_GE(study.usable, trials - 2);  // 4 deviations of χ² are few
  EXPECT_EQ(study.contradicting, 0u);
  ASSERT_EQ(study.values.size(), 4u);
  for (const StudiedValue& value : study.values) {
    // The rms of 60 errors is off by 9 %; of 60 intervals 57 ± 1.7 hold the truth.
    EXPECT_NEAR(value.rms_error / value.bound, 1.0, 0.36) << value.name;
    EXPECT_GE(value.covered, 50u) << value.name;
    EXPECT_LT(std::abs(value.bias), 4.0 * value.bound / std::sqrt(static_cast<double>(value.trials))) << value.name;
  }
  EXPECT_NEAR(study.chi_square, 1.0, 0.2);
}

/// Far below slip a joint is a spring, whatever its law: parameters that nothing shows are no reason to leave the true law out.
TEST_F(LawStudyScene, LawsOfMoreParametersAreNotLeftOutForTheirNumber) {
  LawScene scene = scene_;
  scene.levels[0].amplitude = 5e-4;
  scene.levels[1].amplitude = 1e-3;
  scene.joints[0].laws = {"shoukry", "ren"};
  scene.joints[0].assumed_law = "ren";
  scene.joints[0].assumed = {1e-5, 2.0, 4e5};
  const LawStudy study = study_laws(scene, {.trials = 20, .seed = 5, .threads = 2});
  EXPECT_GE(study.usable, 19u);
  EXPECT_GE(study.undecided + 3, study.usable);  // 95 % of them, and what 20 of them may be off
  EXPECT_LE(study.missed, 3u);
}

/// The likelihood of a comparison is that of a study of the same trials, and both ways have the truth in their reach.
TEST_F(LawStudyScene, WaysAreComparedOnTheSameTests) {
  const LawStudyOptions options = {.trials = 12, .seed = 3, .threads = 2};
  const LawStudy study = study_laws(scene_, options);
  const LawComparison compared = compare_law_ways(scene_, options);
  ASSERT_EQ(study.usable, options.trials);
  ASSERT_EQ(compared.values.size(), 2u);
  EXPECT_EQ(compared.without_response, 0u);
  for (std::size_t i = 0; i < compared.values.size(); ++i) {
    const ComparedValue& value = compared.values[i];
    EXPECT_EQ(value.name, study.values[i].name);
    EXPECT_EQ(value.truth, study.values[i].truth);
    EXPECT_EQ(value.ways[0].answers, options.trials);
    EXPECT_EQ(value.ways[0].rms_error, study.values[i].rms_error) << value.name;
    EXPECT_EQ(value.ways[0].bias, study.values[i].bias) << value.name;
    EXPECT_GE(value.ways[1].answers, options.trials - 2);
    EXPECT_GT(value.ways[1].rms_error, value.ways[0].rms_error) << value.name;
    EXPECT_LT(value.ways[1].rms_error, 0.1 * value.truth) << value.name;
  }
  EXPECT_GT(compared.seconds[0], 0.0);
}

TEST_F(LawStudyScene, DoesNotDependOnTheThreads) {
  const LawStudy one = study_laws(scene_, {.trials = 6, .seed = 9, .threads = 1});
  const LawStudy three = study_laws(scene_, {.trials = 6, .seed = 9, .threads = 3});
  const LawStudy other = study_laws(scene_, {.trials = 6, .seed = 10, .threads = 3});
  ASSERT_EQ(one.values.size(), three.values.size());
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    EXPECT_EQ(one.values[i].rms_error, three.values[i].rms_error);
    EXPECT_EQ(one.values[i].bias, three.values[i].bias);
  }
  EXPECT_NE(one.values[0].bias, other.values[0].bias);
}

TEST_F(LawStudyScene, EndsWhenItIsInterrupted) {
  std::atomic<std::size_t> done = 0;
  EXPECT_THROW(study_laws(scene_, {.trials = 1000,
                                   .seed = 1,
                                   .threads = 1,
                                   .interrupted = [&] { return done >= 2; },
                                   .progress = [&](std::size_t so_far, std::size_t) { done = so_far; }}),
               Interrupted);
  EXPECT_EQ(done, 2u);
}

}  // namespace
}  // namespace jointid::laws
