#include "laws/task/identify_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/control.hpp"
#include "base/statistics.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

LawScene written(const std::string& name, const TestFolder& folder, bool clean) {
  return read_law_scene(problems::write(problems::make_law_problem(name), folder, {.clean = clean}));
}

double relative(double found, double expected) { return std::abs(found / expected - 1.0); }

/// One percent of noise on the FRFs of the part and on the phasors: the law is found, its stiffness and limit within four
/// deviations.
TEST(IdentifyLaws, FindsTheIwanJointOfAMass) {
  const TestFolder folder;
  LawScene scene = written("sdof-iwan", folder, false);
  scene.joints[0].laws = {"shoukry", "iwan"};
  const LawIdentification found = identify_laws(scene);
  EXPECT_EQ(name(found.status), "ok") << found.message;
  EXPECT_EQ(found.laws(), (std::vector<std::string>{"iwan"}));
  const response::FittedJoint& joint = found.fit().joints[0];
  EXPECT_LT(std::abs(joint.stiffness.value - 4e5), 4.0 * *joint.stiffness.std_error);
  EXPECT_LT(std::abs(joint.limit.value - 10.0), 4.0 * *joint.limit.std_error);
  EXPECT_EQ(found.steps.size(), found.data.states.size());
}

/// Asked to end at the first or the tenth time that it asks, it ends there; and threads change no bit.
TEST(IdentifyLaws, EndsWhenAskedToAndDoesNotDependOnThreads) {
  const TestFolder folder;
  LawScene scene = written("sdof-iwan", folder, false);
  scene.joints[0].laws = {"bilinear"};
  scene.harmonics = {1};
  for (const int wanted : {1, 10}) {
    int asked = 0;
    EXPECT_THROW(identify_laws(scene, {.interrupted = [&] { return ++asked >= wanted; }}), Interrupted);
    EXPECT_EQ(asked, wanted);
  }
  const response::LawFit one = identify_laws(scene).fit(), three = identify_laws(scene, {.threads = 3}).fit();
  EXPECT_EQ(one.values, three.values);
  EXPECT_EQ(one.covariance, three.covariance);
}

TEST(IdentifyLaws, FindsTheLawsOfAFrameWithoutNoise) {
  const TestFolder folder;
  LawScene scene = written("frame-laws", folder, true);
  scene.joints[0].laws = {"bilinear"};
  scene.joints[1].laws = {"ren"};
  scene.harmonics = {1, 3, 5, 7, 9, 11};
  const LawIdentification found = identify_laws(scene);
  EXPECT_EQ(name(found.status), "ok") << found.message;
  EXPECT_LT(relative(found.fit().joints[0].stiffness.value, 1e6), 1e-6);
  EXPECT_LT(relative(found.fit().joints[1].stiffness.value, 1.5e6), 1e-6);
  EXPECT_LT(relative(found.fit().joints[0].limit.value, 4.0), 1e-6);
}

/// Two joints, 1 % of noise on the FRFs of the parts, too: minima far from the truth are not where the fit ends. The motion has
/// the two measured harmonics alone, which is quick.
TEST(IdentifyLaws, FindsTheLawsOfAFrameOfNoisyParts) {
  problems::LawProblem problem = problems::frame_with_joints();
  problem.model = {1, 3};
  const auto exact = problems::measure(problem);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto data = problems::states_of(problem, problems::polluted(problem, exact, seed));
    ASSERT_FALSE(data.structure->errors(data.states[0].omega).empty());
    const auto starts = response::law_starts(*data.structure, data.states, {"bilinear", "ren"}, {{.name = "a"}, {.name = "b"}});
    const response::LawFit fit = response::fit_from(data.structure, data.states, starts, {.harmonics = {1, 3}});
    EXPECT_EQ(word(fit.status), "converged") << seed;
    EXPECT_LT(fit.chi_square, chi_square_quantile(static_cast<double>(fit.freedom), 4.0)) << seed;
    const double stiffness[] = {1e6, 1.5e6}, limit[] = {4.0, 1.5 * (std::exp(2.0) - 1.0) / 2.0};
    for (std::size_t j = 0; j < 2; ++j) {
      const response::FittedJoint& joint = fit.joints[j];
      EXPECT_LT(std::abs(joint.stiffness.value - stiffness[j]), 4.0 * *joint.stiffness.std_error) << seed;
      EXPECT_LT(std::abs(joint.limit.value - limit[j]), 4.0 * *joint.limit.std_error) << seed;
    }
  }
}

/// 1 and 30 N, a frame with 1 % of noise: where the first starts end, a joint that never slips has no way back (14 lines), or a
/// kink of one state holds the fit up (20); more than twice as many lines as a start needs are told by some of them first.
TEST(IdentifyLaws, FindsTheLawsOfAFrameWhereStartsGoAstray) {
  for (const std::size_t count : {14u, 20u, 41u}) {
    problems::LawProblem problem = problems::frame_with_joints();
    problem.model = {1, 3};
    problem.levels = {1.0, 30.0};
    problem.frequency_hz.clear();
    for (std::size_t i = 0; i < count; ++i)
      problem.frequency_hz.push_back(50.0 + 20.0 * static_cast<double>(i) / static_cast<double>(count - 1));
    const auto data = problems::states_of(problem, problems::polluted(problem, problems::measure(problem), 1));
    const auto starts = response::law_starts(*data.structure, data.states, {"bilinear", "ren"}, {{.name = "a"}, {.name = "b"}});
    const response::LawFit fit = response::fit_from(data.structure, data.states, starts, {.harmonics = {1, 3}});
    EXPECT_TRUE(is_minimum(fit.status)) << count;
    EXPECT_LT(fit.chi_square, chi_square_quantile(static_cast<double>(fit.freedom), 4.0)) << count;
    EXPECT_LT(std::abs(fit.joints.at(0).stiffness.value - 1e6), 5.0 * *fit.joints.at(0).stiffness.std_error) << count;
  }
}

/// Rig two: the joint's motion is a difference of motions a hundred times larger, so that single states tell its stiffness to 10
/// to 30 % at most. All together tell it to 0.1 %, limit as well.
TEST(IdentifyLaws, FindsTheJointOfRigTwo) {
  const problems::LawProblem problem = problems::make_law_problem("rig2-laws");
  const auto exact = problems::measure(problem);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto data = problems::states_of(problem, problems::polluted(problem, exact, seed));
    const auto starts = response::law_starts(*data.structure, data.states, {"ren"}, {{.name = "joint"}});
    const response::LawFit fit = response::fit_from(data.structure, data.states, starts);
    ASSERT_FALSE(fit.joints.empty()) << seed;
    EXPECT_LT(fit.chi_square, chi_square_quantile(static_cast<double>(fit.freedom), 4.0)) << seed;
    const response::FittedJoint& joint = fit.joints[0];
    EXPECT_LT(std::abs(joint.stiffness.value - 8.2e6), 4.0 * *joint.stiffness.std_error) << seed;
    EXPECT_LT(std::abs(joint.limit.value - 14.49), 4.0 * *joint.limit.std_error + 0.005) << seed;
    EXPECT_LT(*joint.stiffness.std_error, 2e-3 * 8.2e6) << seed;
  }
}

/// A prior of the stiffness as narrow as the data's own deviation narrows it by √2 at most, and is counted.
TEST(IdentifyLaws, PriorsAndBoundsCount) {
  const TestFolder folder;
  LawScene scene = written("sdof-iwan", folder, true);
  scene.joints[0].laws = {"iwan"};
  scene.harmonics = {1, 3, 5, 7, 9};
  const response::LawFit alone = identify_laws(scene).fit();
  const double deviation = *alone.joints[0].parameters[0].std_error;
  scene.constraints.rules = {{0, "f", {}, {{10.0, deviation}}}, {0, "k", {{1e5, 1e6}}, {}}};
  const response::LawFit with = identify_laws(scene).fit();
  EXPECT_EQ(with.numbers, alone.numbers + 1);
  EXPECT_NEAR(*with.joints[0].parameters[0].std_error, deviation / std::sqrt(2.0), 1e-3 * deviation);
  EXPECT_LT(relative(with.joints[0].limit.value, 10.0), 1e-5);
}

}  // namespace
}  // namespace jointid::laws
