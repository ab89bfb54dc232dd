#include "problems/vibration/rig_two.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <filesystem>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/lu.hpp"
#include "friction/curve/equivalent.hpp"
#include "friction/law/laws.hpp"
#include "rig_two_table.hpp"
#include "tasks/equivalent.hpp"
#include "tests/test_folder.hpp"

namespace jointid::problems {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(EquivalentJoint, InvertsTheCoupledFrfs) {
  std::srand(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Complex z = std::polar(std::pow(10.0, 1.0 + trial % 7), 0.014 * trial);
    tasks::JointLines lines;
    std::vector<Complex> h1_rigid, h3_rigid;
    for (int line = 0; line < 5; ++line) {
      Eigen::Matrix2cd h = 1e-4 * Eigen::Matrix2cd::Random();
      h(1, 0) = h(0, 1);
      const auto joined = [&h](Complex joint) {  // (6.15), docs/formulas.md §2
        const Eigen::Matrix2cd stiffness = joint * (Eigen::Matrix2cd() << 1.0, -1.0, -1.0, 1.0).finished();
        return Eigen::Matrix2cd(h * dense::inverse(Eigen::Matrix2cd::Identity() + stiffness * h));
      };
      lines.a.push_back(h(0, 0));
      lines.b.push_back(h(1, 1));
      lines.c.push_back(h(0, 1));
      lines.h1.push_back(joined(z)(0, 0));
      lines.h3.push_back(joined(z)(1, 0));
      h1_rigid.push_back(joined(1e12)(0, 0));
      h3_rigid.push_back(joined(1e12)(1, 0));
    }
    lines.gap = difference_gap(lines);
    lines.relative = trial % 2 == 0;
    const tasks::EquivalentJoint found = equivalent_joint(lines);
    EXPECT_TRUE(found.settled);
    EXPECT_LT(std::abs(Complex(found.stiffness, found.damping) - z), 1e-8 * std::abs(z)) << trial;
    EXPECT_LT(found.misfit, 1e-9);
    const std::vector<Complex> rigid = rigid_gap(lines, h1_rigid, h3_rigid);
    for (std::size_t i = 0; i < rigid.size(); ++i) EXPECT_LT(std::abs(rigid[i] - lines.gap[i]), 1e-4 * std::abs(lines.gap[i]));
  }
}

TEST(EquivalentJoint, RealFrfsKeepSizeAndSign) {
  EXPECT_EQ(tasks::real_frf({3.0, 4.0}), Complex(5.0));
  EXPECT_EQ(tasks::real_frf({-3.0, 4.0}), Complex(-5.0));
}

TEST(RigTwo, WithoutErrorsTheDescribingFunctionComesBack) {
  for (const ProblemInfo& info : list_rig_two()) {
    const RigTwo rig = make_rig_two(info.name);
    const auto element = friction::make_element("ren", rig.element);
    const friction::Curve found = equivalents(rig, {.rigid = false, .real = false, .relative = false}), reference = equivalents(rig, {});
    for (std::size_t i = 0; i < found.u.size(); ++i) {
      const friction::Equivalent exact = friction::equivalent(*element, found.u[i]);
      const double size = std::hypot(exact.stiffness, exact.damping);
      EXPECT_NEAR(found.value[i], exact.stiffness, 1e-6 * size);
      EXPECT_NEAR(found.damping[i], exact.damping, 1e-6 * size);
      // The clamped joint is not quite rigid, and the parts are not without damping.
      EXPECT_NEAR(reference.value[i], exact.stiffness, 0.03 * size);
      EXPECT_NEAR(reference.damping[i], exact.damping, 0.03 * size);
    }
    EXPECT_NEAR(limit_ratio(rig, {}), 1.0, 0.02);
  }
}

TEST(RigTwo, WithTheErrorsOfItsTestsTheFrictionLimitIsWithinFifteenPercent) {
  for (const ProblemInfo& info : list_rig_two()) {
    const RigTwo rig = make_rig_two(info.name);
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      EXPECT_NEAR(limit_ratio(polluted(rig, seed), {}), 1.0, 0.15) << info.name << " seed " << seed;
  }
}

class RigTwoFiles : public testing::Test {
 protected:
  TestFolder folder_;
};

TEST_F(RigTwoFiles, GiveWhatTheSetsInMemoryGive) {
  const RigTwo rig = make_rig_two("rig2");
  ident::EquivalentScene scene = ident::read_equivalent_scene(write(rig, folder_, {.format = "h5", .seed = 3, .clean = false}));
  for (const bool rigid : {true, false}) {
    if (!rigid) scene.rigid.reset();
    const friction::Curve expected = equivalents(polluted(rig, 3), {.rigid = rigid});
    const std::vector<tasks::LevelJoint> found = tasks::find_equivalent(scene);
    ASSERT_EQ(found.size(), expected.u.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].displacement, expected.u[i]);
      EXPECT_NEAR(found[i].joint.stiffness, expected.value[i], 1e-9 * std::abs(expected.value[i]));
      EXPECT_NEAR(found[i].joint.damping, expected.damping[i], 1e-9 * std::abs(expected.damping[i]));
      EXPECT_EQ(found[i].lines, 37u);
    }
  }
}

std::string error_of(const std::string& equivalent) {
  try {
    ident::parse_equivalent_scene("[data]\nparts = [\"p.h5\"]\n[equivalent]\n" + equivalent, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(EquivalentScene, SaysWhatIsWrong) {
  const std::string ends = "dofs = [\"1:+Y\", \"2:+Y\"]\n", level = "levels = [{ assembly = \"a.h5\", displacement = 1e-6 }]\n";
  EXPECT_EQ(error_of(ends + level), "no error");
  EXPECT_THAT(error_of("dofs = [\"1:+Y\"]\n" + level), HasSubstr("two ends"));
  EXPECT_THAT(error_of(ends), HasSubstr("levels"));
  EXPECT_THAT(error_of(ends + "levels = []"), HasSubstr("[equivalent] levels"));
  EXPECT_THAT(error_of(ends + "levels = [{ assembly = \"a.h5\", displacement = 0 }]"), HasSubstr("displacement"));
  EXPECT_THAT(error_of(ends + "levels = [{ assembly = \"a.h5\" }]"), HasSubstr("displacement"));
  EXPECT_THAT(error_of(ends + level + "rigd = \"r.h5\""), HasSubstr("did you mean rigid?"));
  EXPECT_THAT(error_of(ends + level + "weighting = \"relativ\""), HasSubstr("relative"));
}

TEST_F(RigTwoFiles, SayWhichLevelHasNoCommonLine) {
  ident::EquivalentScene scene = ident::read_equivalent_scene(write(make_rig_two("rig2"), folder_, {}));
  scene.dofs = {frf::Dof::parse("109:+Y"), frf::Dof::parse("110:+Y")};
  try {
    tasks::find_equivalent(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("110:+Y"));
    EXPECT_EQ(error.kind(), ErrorKind::data);
  }
}

}  // namespace
}  // namespace jointid::problems
