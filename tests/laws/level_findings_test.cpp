#include "laws/task/level_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/direct_identification.hpp"
#include "laws/task/law_study.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

/// One bilinear joint on a mass at four levels, of which one may have been measured with another joint.
class DriftingLevel : public testing::Test {
 protected:
  static problems::LawProblem problem(double slip) {
    problems::LawProblem one = problems::make_law_problem("sdof-iwan");
    one.levels = {2.0, 6.0, 15.0, 40.0};
    one.joints[0].law = "bilinear";
    one.joints[0].parameters = {slip, 4e5};
    one.model = {1, 3};
    return one;
  }

  DriftingLevel() {
    const problems::LawProblem written = problem(2.5e-5);
    scene_ = read_law_scene(problems::write(written, folder_, {}));
    scene_.joints[0].laws = {"bilinear"};
    scene_.harmonics = {1, 3};
  }

  /// Level `drifted` with another friction limit.
  LevelStates states(std::uint64_t seed, std::size_t drifted, double by) const {
    const problems::LawProblem usual = problem(2.5e-5), other = problem(2.5e-5 * by);
    problems::LawMeasurement all = problems::measure(usual);
    const problems::LawMeasurement changed = problems::measure(other);
    all.responses[drifted] = changed.responses[drifted];
    problems::LawStates data = problems::states_of(usual, problems::polluted(usual, all, seed));
    LevelStates out;
    out.structure = data.structure;
    out.responses = usual.responses;
    out.states = std::move(data.states);
    for (std::size_t i = 0; i < out.states.size(); ++i) out.level.push_back(i / usual.frequency_hz.size());
    return out;
  }

  TestFolder folder_;
  LawScene scene_;
};

TEST_F(DriftingLevel, IsTold) {
  const LawIdentification found = identify_states(scene_, states(1, 2, 1.2));
  ASSERT_EQ(found.drifts.size(), 4u);
  EXPECT_TRUE(found.drifts[0].is_told());
  EXPECT_EQ(found.drifts[0].level, 2u);
  EXPECT_EQ(found.drifts[0].freedom, 2);
  EXPECT_THAT(found.notes, testing::Contains(HasSubstr("15.0 N speaks for another joint")));
  EXPECT_NE(found.status, Status::ok);
}

/// χ² of chance: twenty measurements without drift, of 2 degrees each level has 2 in the mean, and none is told.
TEST_F(DriftingLevel, IsNotToldOfOneJoint) {
  double sum = 0.0;
  constexpr int seeds = 20;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const LawIdentification found = identify_states(scene_, states(seed, 2, 1.0));
    ASSERT_EQ(found.drifts.size(), 4u);
    EXPECT_FALSE(found.drifts[0].is_told()) << seed << ": " << found.drifts[0].chi_square;
    for (const response::LevelDrift& drift : found.drifts) sum += drift.chi_square / (4.0 * seeds);
  }
  EXPECT_NEAR(sum, 2.0, 1.0);
}

/// The fall of χ² is that of a fit in which the level has parameters of its own, to first order: of a small drift.
TEST_F(DriftingLevel, TheFallIsThatOfFitsApart) {
  const LevelStates all = states(3, 3, 1.03);
  const LawIdentification together = identify_states(scene_, all);
  ASSERT_EQ(word(together.fit().status), "converged");
  double apart = 0.0;
  for (const bool drifted : {false, true}) {
    LevelStates some = all;
    some.states.clear();
    some.level.clear();
    for (std::size_t i = 0; i < all.states.size(); ++i) {
      if ((all.level[i] == 3) != drifted) continue;
      some.states.push_back(all.states[i]);
      some.level.push_back(all.level[i]);
    }
    apart += identify_states(scene_, some).fit().chi_square;
  }
  const auto drift = std::ranges::find(together.drifts, 3u, &response::LevelDrift::level);
  ASSERT_NE(drift, together.drifts.end());
  // Apart the errors of the part are free twice, so that χ² falls by more.
  EXPECT_GT(together.fit().chi_square - apart, 0.9 * drift->chi_square);
  EXPECT_GT(drift->chi_square, 5.0);
}

/// Of a force with a second harmonic.
TEST(EvenHarmonics, AreTold) {
  response::DirectStep step;
  step.harmonics = {1, 2, 3};
  step.joint_force = Eigen::MatrixXcd::Zero(3, 2);
  step.joint_force << 10.0, 10.0, 0.1, 1.0, 1.0, 1.0;
  step.joint_motion = Eigen::MatrixXcd::Constant(3, 2, 1e-6);
  step.force_deviation = step.motion_deviation = Eigen::MatrixXcd::Constant(3, 2, Complex(0.1, 0.1));
  const std::vector<OneSidedJoint> found = test_even_harmonics({step, step}, 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].freedom, 4);
  EXPECT_NEAR(found[0].chi_square, 2.0, 1e-12);
  EXPECT_FALSE(found[0].is_told());
  EXPECT_NEAR(found[1].chi_square, 200.0, 1e-9);
  EXPECT_TRUE(found[1].is_told());
  EXPECT_NEAR(found[1].largest_share, 0.1, 1e-12);
  EXPECT_THAT(one_sided_text(found[1], "slot"), HasSubstr("slot: its force has even harmonics, up to 10 %"));
  step.harmonics = {1, 3, 5};
  EXPECT_EQ(test_even_harmonics({step}, 2)[0].freedom, 0);
}

std::string planned_text(const std::string& errors) {
  std::string text = "[data]\nparts = [\"sdof-iwan_part_1.h5\"]\n";
  for (const char* level : {"4.0", "20.0"})
    text += std::string("[[data.levels]]\namplitude = ") + level + "\nforce_dofs = [\"1:+Y\"]\nharmonics = [1, 3]\n";
  return text +
         "[[joint.friction]]\nname = \"slot\"\ndofs = [\"1:+Y\"]\nlaw = \"bilinear\"\nassumed = { a = 1e-5, k = 4e5 }\n"
         "[frequency]\nrange = [80.0, 135.0]\n[identify]\nharmonics = [1, 3]\n[errors]\n" +
         errors;
}

/// Errors of forces of 3 % beside 1 % of everything else: stated, they widen the bound, and estimates scatter by it.
TEST(ForceErrors, AreCounted) {
  const TestFolder folder;
  problems::write(problems::make_law_problem("sdof-iwan"), folder, {});
  const auto study_of = [&](const std::string& errors) {
    return study_laws(parse_law_scene(planned_text(errors), folder / "plan.toml"), {.trials = 60, .seed = 5, .threads = 2});
  };
  const LawStudy without = study_of("relative = 0.01\n"), with = study_of("relative = 0.01\nforce = 0.03\n");
  ASSERT_EQ(with.values.size(), without.values.size());
  EXPECT_GE(with.usable, 58u);
  EXPECT_EQ(with.contradicting, 0u);
  EXPECT_NEAR(with.chi_square, 1.0, 0.2);
  for (std::size_t i = 0; i < with.values.size(); ++i) {
    const StudiedValue& value = with.values[i];
    EXPECT_GT(value.bound, 1.2 * without.values[i].bound) << value.name;
    EXPECT_NEAR(value.rms_error / value.bound, 1.0, 0.36) << value.name;
    EXPECT_GE(value.covered, 50u) << value.name;
  }
}

/// The law is chosen among several, and the true one named beside them.
TEST(LawChoice, OfAStudyIsCounted) {
  const TestFolder folder;
  problems::write(problems::make_law_problem("sdof-iwan"), folder, {});
  std::string text = planned_text("relative = 0.01\n");
  const std::string one = "law = \"bilinear\"\nassumed = { ";
  text.replace(text.find(one), one.size(), "law = [\"bilinear\", \"shoukry\"]\nassumed = { law = \"bilinear\", ");
  const LawStudy study = study_laws(parse_law_scene(text, folder / "plan.toml"), {.trials = 4, .seed = 1, .threads = 2});
  EXPECT_EQ(study.laws, (std::vector<std::string>{"bilinear"}));
  EXPECT_EQ(study.right, study.usable);
  EXPECT_EQ(study.missed, 0u);
  text.replace(text.find("{ law = \"bilinear\", "), 20, "{ ");
  EXPECT_THAT(
      [&]() -> std::string {
        try {
          parse_law_scene(text, folder / "plan.toml");
        } catch (const InputError& error) {
          return error.what();
        }
        return "none";
      }(),
      HasSubstr("parameters of which of several laws?"));
}

/// What is told without a law is what `solve` tells beside one.
TEST(DirectIdentification, IsTheStepBeforeAFit) {
  const TestFolder folder;
  LawScene scene = read_law_scene(problems::write(problems::make_law_problem("sdof-iwan"), folder, {}));
  scene.joints[0].laws = {"iwan"};
  const DirectIdentification found = identify_directly(scene);
  EXPECT_EQ(name(found.status), "ok") << found.message;
  const LawIdentification solved = identify_laws(scene);
  ASSERT_EQ(found.steps.size(), solved.steps.size());
  for (std::size_t i = 0; i < found.steps.size(); ++i) EXPECT_EQ(found.steps[i].equivalent, solved.steps[i].equivalent);
  EXPECT_GT(found.known[0], found.steps.size() / 2);
}

/// Responses that a thousand times larger errors hide.
TEST(DirectIdentification, SaysWhatNoStateTells) {
  const TestFolder folder;
  LawScene scene = read_law_scene(problems::write(problems::make_law_problem("sdof-iwan"), folder, {.clean = true}));
  scene.errors->relative = 5.0;
  const DirectIdentification found = identify_directly(scene);
  EXPECT_EQ(name(found.status), "doubtful");
  EXPECT_EQ(found.known[0], 0u);
  EXPECT_THAT(found.message, HasSubstr("joint: no state determines its stiffness"));
}

}  // namespace
}  // namespace jointid::laws
