#include <gmock/gmock.h>

#include <functional>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "memory_systems.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two parts with every DOF in both roles, joint 4:+Y 5:+Y.
MemoryScene input() {
  std::mt19937_64 random(1);
  const std::vector<double> lines = {10.0, 20.0, 30.0, 40.0};
  const Dofs a = dofs({"1:+Y", "4:+Y"}), b = dofs({"5:+Y", "9:+Y"});
  MemoryScene input;
  input.substructures = {random_set("a", lines, a, a, 1.0, random), random_set("b", lines, b, b, 1.0, random)};
  input.assembly = {random_set("assembly", lines, joined(a, b), joined(a, b), 1.0, random)};
  input.scene.file = "scene.toml";
  input.scene.joints = {joint_of(dofs({"4:+Y", "5:+Y"}), Kind::stiffness, Pattern::symmetric)};
  return input;
}

/// Keeps some DOFs of every set of a system in one role.
void keep(std::vector<frf::FrfSet>& sets, bool responses, const std::vector<std::string>& names) {
  for (frf::FrfSet& set : sets) {
    Dofs kept;
    for (const frf::Dof& dof : responses ? set.header.response : set.header.reference) {
      if (frf::find_coordinate(dofs(names), dof) != frf::npos) kept.push_back(dof);
    }
    set = responses ? part_of(set, kept, set.header.reference) : part_of(set, set.header.response, kept);
  }
}

void expect_error(const std::function<void()>& act, ErrorKind kind, const std::vector<std::string>& parts) {
  try {
    act();
    FAIL() << "no error; expected: " << parts[0];
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    for (const std::string& part : parts) EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

void expect_usage(const MemoryScene& input, const std::vector<std::string>& parts) {
  expect_error([&] { input.plan(); }, ErrorKind::usage, parts);
}

TEST(PlanError, TheInputItselfIsFine) { EXPECT_EQ(input().plan()->equations.size(), 4u); }

TEST(PlanError, ADofThatNoSubstructureHasIsNamedWithTheNearest) {
  MemoryScene wrong = input();
  wrong.scene.joints[0].dofs = dofs({"4:+Y", "5:+Z"});
  expect_usage(wrong, {"scene.toml", "[joint] dofs", "no substructure file has the DOF 5:+Z", "did you mean 5:+Y?"});
}

TEST(PlanError, ADofThatTheAssemblyLacksIsSaidByTheEquation) {
  MemoryScene wrong = input();
  keep(wrong.assembly, false, {"1:+Y", "4:+Y", "9:+Y"});
  wrong.scene.identify.equations = {Equation::nn};
  expect_usage(wrong, {"[identify] equations", "equation nn cannot be used: the assembly has no reference 5:+Y",
                       "leave it out, measure what it lacks, or let `jointid check` look for a mistaken label"});
}

struct Lack {
  Equation equation;
  bool assembly, responses;
  std::vector<std::string> kept;
  const char* message;
};

TEST(PlanError, EachEquationSaysWhatItLacks) {
  const std::vector<std::string> joint = {"4:+Y", "5:+Y"}, other = {"1:+Y", "9:+Y"}, no_four = {"1:+Y", "5:+Y", "9:+Y"};
  const Lack lacks[] = {
      {Equation::nn, true, true, joint, "no non-joint response"},
      {Equation::nn, true, false, joint, "no non-joint reference"},
      {Equation::nn, false, true, no_four, "the substructures have no response 4:+Y"},
      {Equation::nj, true, true, joint, "no non-joint response"},
      {Equation::nj, true, false, other, "the assembly has no reference 4:+Y"},
      {Equation::nj, false, true, no_four, "the substructures have no response 4:+Y"},
      {Equation::nj, false, false, no_four, "the substructures have no reference 4:+Y"},
      {Equation::jj, true, true, no_four, "the assembly has no response 4:+Y"},
      {Equation::jj, true, false, no_four, "the assembly has no reference 4:+Y"},
      {Equation::jj, false, true, no_four, "the substructures have no response 4:+Y"},
      {Equation::jj, false, false, no_four, "the substructures have no reference 4:+Y"},
      {Equation::jn, true, false, joint, "no non-joint reference"},
      {Equation::jn, true, true, no_four, "the assembly has no response 4:+Y"},
      {Equation::jn, true, false, no_four, "the assembly has no reference 4:+Y"},
      {Equation::jn, false, true, no_four, "the substructures have no response 4:+Y"},
  };
  for (const Lack& lack : lacks) {
    MemoryScene wrong = input();
    wrong.scene.identify.equations = {lack.equation};
    keep(lack.assembly ? wrong.assembly : wrong.substructures, lack.responses, lack.kept);
    expect_usage(wrong, {"equation " + name(lack.equation) + " cannot be used", lack.message});
    // Unnamed, the equation is left out instead (unless none is left).
    wrong.scene.identify.equations.clear();
    try {
      EXPECT_THAT(wrong.plan()->equations, ::testing::Not(::testing::Contains(lack.equation)));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("the data allow no equation"));
    }
  }
}

TEST(PlanError, EquationsAreInOrderAndThoseTheDataAllow) {
  MemoryScene fine = input();
  fine.scene.identify.equations = {Equation::jn, Equation::nn};
  EXPECT_THAT(fine.plan()->equations, ElementsAre(Equation::nn, Equation::jn));
  fine.scene.identify.equations.clear();
  keep(fine.assembly, true, {"1:+Y", "9:+Y"});
  EXPECT_THAT(fine.plan()->equations, ElementsAre(Equation::nn, Equation::nj));
}

TEST(PlanError, MethodTwoHasTwoEquationsAndSaysWhatTheyLack) {
  MemoryScene wrong = input();
  wrong.scene.identify.method = Method::two;
  EXPECT_THAT(wrong.plan()->equations, ElementsAre(Equation::jj, Equation::jn));
  wrong.scene.identify.equations = {Equation::nj};
  expect_usage(wrong, {"Method Two has the equations jn and jj only"});
  wrong.scene.identify.equations.clear();
  keep(wrong.assembly, true, {"1:+Y", "9:+Y"});
  expect_usage(wrong, {"the data allow no equation", "the assembly has no response 4:+Y"});
}

TEST(PlanError, TheDirectSolutionNeedsReferencesAndNnOnly) {
  MemoryScene wrong = input();
  wrong.scene.identify.method = Method::direct;
  EXPECT_THAT(wrong.plan()->equations, ElementsAre(Equation::nn));
  wrong.scene.identify.equations = {Equation::jj};
  expect_usage(wrong, {"the direct solution uses the equation nn only"});
  wrong.scene.identify.equations.clear();
  keep(wrong.assembly, false, {"1:+Y", "4:+Y", "5:+Y"});
  expect_usage(wrong, {"at least as many non-joint references (1) as joint DOFs (2)"});
}

TEST(PlanError, WithoutJointCoordinatesOnTheAssemblyTheRemedyIsTheLikelihoodWithAStart) {
  MemoryScene wrong = input();
  keep(wrong.assembly, true, {"1:+Y", "9:+Y"});
  keep(wrong.assembly, false, {"1:+Y", "9:+Y"});
  expect_usage(wrong, {"the data allow no equation", "use method = \"likelihood\" with a start", "bears no noise"});
}

TEST(PlanError, ARangeWithoutLinesNamesTheAxes) {
  MemoryScene wrong = input();
  wrong.scene.frequency.range_hz = {{11.0, 19.0}};
  expect_usage(wrong, {"[frequency]", "the selection leaves no line", "10 to 40 Hz in 4 lines"});
  wrong.scene.frequency.range_hz.reset();
  wrong.scene.frequency.exclude_hz = {{0.0, 100.0}};
  expect_usage(wrong, {"the selection leaves no line"});
}

TEST(PlanError, AxesWithoutACommonLineAreAnErrorOfTheData) {
  MemoryScene wrong = input();
  wrong.assembly[0].header.frequency_hz = {12.0, 22.0, 32.0, 42.0};
  expect_error([&] { wrong.plan(); }, ErrorKind::data, {"no selected line is common to substructures and assembly"});
  MemoryScene parts = input();
  parts.substructures[1].header.frequency_hz = {12.0, 22.0, 32.0, 42.0};
  expect_error([&] { parts.plan(); }, ErrorKind::data, {"no frequency line is common to all files"});
}

TEST(PlanError, AxesWithRoundedIncrementsAreTheSameLines) {
  MemoryScene rounded = input();
  rounded.assembly[0].header.frequency_hz = {10.0, 20.004, 30.009, 40.013};
  const auto plan = rounded.plan();
  ASSERT_EQ(plan->lines.size(), 4u);
  EXPECT_EQ(plan->lines[3].frequency_hz, 40.013);
  EXPECT_TRUE(plan->notes.empty());
}

TEST(PlanError, LinesWithoutAPartnerAreLeftOutWithANote) {
  MemoryScene fewer = input();
  fewer.substructures = {lines_of(fewer.substructures[0], {0, 2, 3}), lines_of(fewer.substructures[1], {0, 2})};
  const auto plan = fewer.plan();
  ASSERT_EQ(plan->lines.size(), 2u);
  EXPECT_EQ(plan->lines[1].frequency_hz, 30.0);
  EXPECT_EQ(plan->lines[1].substructures, 1u);
  EXPECT_EQ(plan->lines[1].assembly, 2u);
  EXPECT_THAT(plan->notes, ElementsAre(HasSubstr("2 selected lines of the assembly have no partner")));
}

TEST(PlanError, ACoordinateInTwoSubstructures) {
  MemoryScene wrong = input();
  wrong.substructures[1].header.response[1] = frf::Dof::parse("1:-Y");
  expect_error([&] { wrong.plan(); }, ErrorKind::data, {"DOF 1:-Y is also in a", "two substructures share no coordinate"});
  MemoryScene reference = input();
  reference.substructures[1].header.reference[1] = frf::Dof::parse("1:+Y");
  expect_error([&] { reference.plan(); }, ErrorKind::data, {"DOF 1:+Y is also in a"});
  MemoryScene frf = input();
  frf.assembly.push_back(part_of(frf.assembly[0], dofs({"4:+Y"}), dofs({"4:+Y"})));
  expect_error([&] { frf.plan(); }, ErrorKind::data, {"FRF 4:+Y / 4:+Y is also in assembly"});
}

TEST(PlanError, MethodsSolversAndKeysThatThisBuildLacks) {
  MemoryScene wrong = input();
  wrong.scene.identify.method = Method::newton;
  wrong.scene.identify.solver = Solver::spqr;
  expect_usage(wrong, {"[identify] solver", "method \"newton\" has no solver \"spqr\"", "use auto, levenberg-marquardt"});
  MemoryScene solver = input();
  solver.scene.identify.solver = Solver::ceres;
  expect_usage(solver, {"has no solver \"ceres\"", "use auto, qr, normal, spqr, cholmod or ldlt"});
  MemoryScene start = input();
  start.scene.identify.start[Kind::stiffness] = {{1.0, 0.0}, {0.0, 1.0}};
  expect_usage(start, {"[identify] start", "needs no start"});
  MemoryScene known = input();
  known.scene.joints[0].matrices[Kind::stiffness] = restrictions::EntryMatrix{{1.0, 2.0}, {2.0, 4.0}};
  expect_usage(known, {"nothing to identify"});
}

}  // namespace
}  // namespace jointid::ident
