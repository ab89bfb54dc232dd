#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "tasks/couple.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& points) {
  try {
    parse_scene(
        "[data]\nsubstructures = [\"a.h5\", \"b.h5\"]\nassembly = [\"c.h5\"]\n[joint]\ndofs = [\"VP1:+X\", \"VP2:+X\"]\n"
        "[joint.stiffness]\npattern = \"symmetric\"\n[nodes]\n\"7\" = [0, 0, 1]\n" +
            points,
        "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string point(const std::string& keys) {
  return "[[virtual_points]]\nname = \"VP1\"\nposition = [0, 0, 0]\nsensors = [\"1:+X\", \"1:+Y\", \"2:+Y\"]\nplane = \"XY\"\n" +
         keys;
}

TEST(VirtualPointScene, SaysWhatIsWrong) {
  EXPECT_EQ(error_of(point("")), "no error");
  EXPECT_THAT(error_of("[[virtual_points]]\nname = \"P1\"\nposition = [0, 0, 0]\n"),
              HasSubstr("'P1' is no name of a virtual point"));
  EXPECT_THAT(error_of("[[virtual_points]]\nname = \"VP1\"\nposition = [0, 0]\n"), HasSubstr("three numbers"));
  EXPECT_THAT(error_of("[[virtual_points]]\nname = \"VP1\"\nposition = [0, 0, 0]\n"), HasSubstr("neither sensors nor impacts"));
  EXPECT_THAT(error_of(point("directions = { \"1:+X\" = [3, 0, 4] }\n")), HasSubstr("the length 5, not 1; write [0.6, 0, 0.8]"));
  EXPECT_THAT(error_of(point("directions = { \"3:+X\" = [1, 0, 0] }\n")), HasSubstr("3:+X is not among the sensors"));
  EXPECT_THAT(error_of(point("impacts = [\"1:+X\"]\n")), HasSubstr("1 impacts cannot determine 3 motions"));
  EXPECT_THAT(error_of(point("flexible = [\"ex\", \"ex\"]\n")), HasSubstr("'ex' is there twice"));
  EXPECT_THAT(error_of(point("files = [\"d.h5\"]\n")), HasSubstr("'d.h5' is no file of [data]"));
  EXPECT_THAT(error_of(point("") + point("")), HasSubstr("VP1 is here twice"));
  EXPECT_EQ(error_of(point("files = [\"a.h5\"]\n") + point("files = [\"c.h5\"]\n")), "no error");
  std::string second = point("");
  second.replace(second.find("VP1"), 3, "VP2");
  EXPECT_THAT(error_of(point("") + second), HasSubstr("1:+X is also in VP1"));
  EXPECT_THAT(
      error_of(point("") +
               "[identify]\nmethod = \"likelihood\"\nvariance = \"noise\"\n[noise]\nmodel = \"circular\"\nlevel = 0.01\n"),
      HasSubstr("the law of measured FRFs"));
}

class Flange : public testing::Test {
 protected:
  Scene written(const std::string& name, bool clean = false) {
    return read_scene(problems::write(problems::make(name), folder_, {.seed = 1, .clean = clean}));
  }

  TestFolder folder_;
};

TEST_F(Flange, ExactFrfsGiveTheJoint) {
  Scene scene = written("flange", true);
  scene.identify.method = Method::one;
  scene.frequency.step_hz = 200.0;
  const Solution solution = solve(*make_plan(scene));
  const problems::Problem problem = problems::make("flange");
  ASSERT_EQ(solution.unknowns.size(), problem.unknowns.size());
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    EXPECT_NEAR(solution.unknowns[i].value, problem.unknowns[i].value, 1e-6 * problem.unknowns[i].value)
        << problem.unknowns[i].name;
  }
}

TEST_F(Flange, CheckNamesTheTurnedSensor) {
  const CheckResult found = check_scene(written("flange-turned"));
  ASSERT_FALSE(found.suspects.empty());
  EXPECT_EQ(title(found.suspects[0]).substr(0, 16), "direction 13:+Y ");
  EXPECT_THAT(found.suspects[0].evidence, HasSubstr("direction [0.0, 0."));
  EXPECT_THAT(found.suspects[0].remedy, HasSubstr("directions = { \"13:+Y\" = ["));
  EXPECT_EQ(found.verdict, Verdict::wrong);
  EXPECT_EQ(found.virtual_points.size(), 4U);  // one in each part, both in the assembly
}

TEST_F(Flange, CheckOfTheStraightOneIsClean) {
  const CheckResult found = check_scene(written("flange"));
  EXPECT_EQ(found.verdict, Verdict::clean);
  for (const virtualpoint::Consistency& each : found.virtual_points) EXPECT_TRUE(each.wrong.empty());
}

std::string text_of(const Matrix& matrix) {
  std::string text;
  for (const auto& row : matrix) {
    std::string numbers;
    for (const double number : row) numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
    text += (text.empty() ? "[" : ", [") + numbers + "]";
  }
  return "{ matrix = [" + text + "] }";
}

/// Parts coupled at their virtual points by the exact joint are the assembly.
TEST_F(Flange, PartsAreCoupledAtVirtualPoints) {
  written("flange", true);
  std::ifstream in(folder_ / "flange.toml");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::size_t begin = text.find("[[virtual_points]]"), end = text.find("[frequency]");
  const problems::Problem problem = problems::make("flange");
  std::string dofs;
  for (const frf::Dof& dof : problem.joint_dofs) dofs += (dofs.empty() ? "\"" : ", \"") + dof.name() + "\"";
  const CoupleScene scene =
      parse_couple_scene("[data]\nparts = [\"flange_part_1.h5\", \"flange_part_2.h5\"]\n" + text.substr(begin, end - begin) +
                             "[couple]\nkeep = [\"104:+X\", \"204:+X\", \"VP1:+RZ\"]\n[couple.joint]\ndofs = [" + dofs +
                             "]\nstiffness = " + text_of(problem.truth.at(restrictions::Kind::stiffness)) +
                             "\nhysteretic_damping = " + text_of(problem.truth.at(restrictions::Kind::hysteretic_damping)) + "\n",
                         folder_ / "couple.toml");
  tasks::couple(scene, folder_ / "out.h5", false);
  const frf::FrfSet coupled = frf::load(*frf::open_hdf5(folder_ / "out.h5"));
  EXPECT_EQ(coupled.header.response[2].name(), "VP1:+RZ");
  const std::size_t from = frf::find_coordinate(problem.assembly.header.reference, frf::Dof::parse("204:+X"));
  const std::size_t to = frf::find_coordinate(problem.assembly.header.response, frf::Dof::parse("104:+X"));
  for (std::size_t line = 0; line < coupled.header.lines(); ++line) {
    const Complex exact = problem.assembly.values[problem.assembly.index(line, to, from)];
    EXPECT_LT(std::abs(coupled.values[coupled.index(line, 0, 1)] - exact), 1e-7 * std::abs(exact)) << line;
  }
}

/// The joint of twelve coordinates from FRFs with 1 % noise: 95 % intervals hold most of the unknowns, none is far off.
TEST_F(Flange, LikelihoodFindsTheJointWithinItsIntervals) {
  Scene scene = written("flange");
  scene.frequency.step_hz = 100.0;
  const Solution solution = solve(*make_plan(scene));
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  const problems::Problem problem = problems::make("flange");
  std::size_t inside = 0;
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    const Estimate& found = solution.unknowns[i];
    ASSERT_TRUE(found.ci95 && found.std_error) << found.name;
    if ((*found.ci95)[0] <= problem.unknowns[i].value && problem.unknowns[i].value <= (*found.ci95)[1]) ++inside;
    EXPECT_LT(std::abs(found.value - problem.unknowns[i].value), 5.0 * *found.std_error) << found.name;
  }
  EXPECT_GE(inside, 9U);
}

}  // namespace
}  // namespace jointid::ident
