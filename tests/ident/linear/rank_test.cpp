#include <gmock/gmock.h>

#include <cmath>

#include "ident/identify.hpp"
#include "tests/ident/memory_systems.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> some_lines(std::size_t count) {
  std::vector<double> lines;
  for (std::size_t i = 1; i <= count; ++i) lines.push_back(5.0 * static_cast<double>(i));
  return lines;
}

/// Two rigidly known FRF sets over 1:+X, 2:+X (joint) and 3:+X, 4:+X of random numbers.
MemoryScene random_data(std::size_t lines, unsigned seed) {
  std::mt19937_64 random(seed);
  const Dofs all = dofs({"1:+X", "2:+X", "3:+X", "4:+X"});
  return {{random_set("parts", some_lines(lines), all, all, 1.0, random)},
          {random_set("assembly", some_lines(lines), all, all, 1.0, random)}};
}

/// Makes 1:+X and 2:+X move alike in the assembly, so that the columns 1 and 2 of a full Z_j cannot be told apart by A.
void tie_joint_references(frf::FrfSet& set) {
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < 4; ++r) set.values[set.index(line, r, 1)] = set.values[set.index(line, r, 0)];
  }
}

Scene scene_with(restrictions::MatrixSpec spec, const std::string& solver, std::vector<Equation> equations = {}) {
  Scene scene;
  scene.joints = {joint_of(dofs({"1:+X", "2:+X"}), Kind::stiffness, std::move(spec))};
  scene.identify.solver = parse_solver(solver);
  scene.identify.equations = std::move(equations);
  scene.identify.weighting = weighting::Weighting::wbs;
  return scene;
}

std::vector<std::string> undetermined(const Solution& solution) {
  std::vector<std::string> names;
  for (const Estimate& estimate : solution.unknowns) {
    if (!estimate.determined) names.push_back(estimate.name);
  }
  return names;
}

TEST(Rank, UnknownsThatMoveTogetherAreNamedAndShareTheirSum) {
  for (const char* solver : {"qr", "spqr"}) {
    MemoryScene data = random_data(5, 1);
    tie_joint_references(data.assembly[0]);
    const std::vector<Equation> nn = {Equation::nn};
    const auto plan = data.plan(scene_with(Pattern::full, solver, nn));
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient) << solver;
    EXPECT_EQ(solution.fit.rank, 2u);
    EXPECT_EQ(undetermined(solution).size(), 4u);
    EXPECT_THAT(solution.message, HasSubstr("do not fix 2 of 4 combinations"));
    EXPECT_THAT(solution.message, HasSubstr("Measure more"));
    // Only K(1,q) + K(2,q) is fixed; the minimum-norm solution gives both the same.
    const auto value = [&](std::size_t u) { return solution.unknowns[u].value; };
    EXPECT_NEAR(value(0), value(2), 1e-12) << solver;
    EXPECT_NEAR(value(1), value(3), 1e-12) << solver;
  }
}

TEST(Rank, WhatTheDataFixStaysDeterminedAndRight) {
  for (const char* solver : {"qr", "spqr"}) {
    MemoryScene data = random_data(5, 2);
    tie_joint_references(data.assembly[0]);
    // y1 stands in one column with y2 in the other; k1 + k2 alone is seen of them, k3 is seen alone.
    const restrictions::EntryMatrix entries = {{"k1", "k3"}, {"k2", 0.0}};
    const std::vector<Equation> nn = {Equation::nn};
    const auto plan = data.plan(scene_with(entries, solver, nn));
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient);
    EXPECT_THAT(undetermined(solution), ElementsAre("K.k1", "K.k2")) << solver;
    EXPECT_THAT(solution.message, HasSubstr("move together"));
    // The same with k1 and k2 as one unknown is well posed.
    const restrictions::EntryMatrix tied = {{"k", "k3"}, {0.0, 0.0}};
    const auto tied_plan = data.plan(scene_with(tied, solver, nn));
    const Solution sum = solve(*tied_plan);
    ASSERT_EQ(sum.status, Status::ok);
    EXPECT_NEAR(solution.unknowns[0].value + solution.unknowns[2].value, sum.unknowns[0].value, 1e-12) << solver;
    EXPECT_NEAR(solution.unknowns[1].value, sum.unknowns[1].value, 1e-12);
  }
}

TEST(Rank, ASmallShareInAFreeDirectionIsNotDeterminedEither) {
  MemoryScene data = random_data(6, 3);
  tie_joint_references(data.assembly[0]);
  // Only k1 + 0.01·k2 is seen: k1 is not fixed although the free direction is nearly k2.
  const restrictions::EntryMatrix entries = {{"k1", "k3"}, {"0.01*k2", 0.0}};
  Scene scene = scene_with(entries, "qr", {Equation::nn});
  scene.identify.weighting = weighting::Weighting::none;
  const auto plan = data.plan(scene);
  EXPECT_THAT(undetermined(solve(*plan)), ElementsAre("K.k1", "K.k2"));
}

TEST(Rank, AColumnWithoutCoefficientsIsFree) {
  for (const char* solver : {"qr", "spqr"}) {
    MemoryScene data = random_data(3, 4);
    for (std::size_t line = 0; line < 3; ++line) {
      for (std::size_t c = 0; c < 4; ++c) data.substructures[0].values[data.substructures[0].index(line, 1, c)] = 0.0;
    }
    const std::vector<Equation> nn = {Equation::nn};
    const auto plan = data.plan(scene_with(Pattern::diagonal, solver, nn));
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient);
    EXPECT_THAT(undetermined(solution), ElementsAre("K(2,2)"));
    EXPECT_THAT(solution.message, HasSubstr("K(2,2) is free"));
    EXPECT_EQ(solution.unknowns[1].value, 0.0);
  }
}

TEST(Rank, NormalEquationsSayThatTheyFailed) {
  MemoryScene data = random_data(3, 4);
  tie_joint_references(data.assembly[0]);
  for (std::size_t line = 0; line < 3; ++line) {
    for (std::size_t c = 0; c < 4; ++c) data.substructures[0].values[data.substructures[0].index(line, 1, c)] = 0.0;
  }
  const std::vector<Equation> nn = {Equation::nn};
  const auto plan = data.plan(scene_with(Pattern::full, "normal", nn));
  const Solution solution = solve(*plan);
  EXPECT_EQ(solution.status, Status::rank_deficient);
  EXPECT_EQ(undetermined(solution).size(), 4u);
  EXPECT_THAT(solution.message, HasSubstr("use solver \"qr\""));
}

TEST(Rank, ALoneLineOfFewCoordinatesCannotFixTwentyUnknowns) {
  const problems::Problem a8 = problems::make("A8");
  for (const weighting::Weighting weighting : all_weightings) {
    Scene scene = problems::scene(a8);
    scene.frequency.range_hz = {{500.0, 500.0}};
    scene.identify.weighting = weighting;
    const auto plan = problems::plan(scene, {a8.substructures, a8.assembly});
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient) << weighting::name(weighting);
    EXPECT_LT(solution.fit.rank, 20u);
    EXPECT_EQ(undetermined(solution).size(), 20u);  // the free directions turn every element of the matrices
  }
}

TEST(NoEquations, AllMissingAllZeroOrAllDropped) {
  const MemoryScene good = random_data(4, 5);
  const auto status = [](const Scene& scene, const MemoryScene& data) {
    const auto plan = data.plan(scene);
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.fit.equations_used, 0u);
    EXPECT_EQ(solution.fit.equations_dropped, 4u * 16u);
    EXPECT_EQ(solution.fit.lines, 0u);
    EXPECT_THAT(solution.message, HasSubstr("No equation is left"));
    return solution.status;
  };
  const Scene scene = scene_with(Pattern::full, "qr");
  MemoryScene missing = good, zero = good, same = good;
  for (Complex& value : missing.assembly[0].values) value = std::numeric_limits<double>::quiet_NaN();
  for (Complex& value : zero.assembly[0].values) value = 0.0;
  same.assembly = same.substructures;
  Scene filtered = scene;
  filtered.identify.delta = 0.01;
  EXPECT_EQ(status(scene, missing), Status::no_equations);
  EXPECT_EQ(status(scene, zero), Status::no_equations);
  EXPECT_EQ(status(filtered, same), Status::no_equations);
}

TEST(NoEquations, WithZerosInTheAssemblyOfMethodTwo) {
  MemoryScene data = random_data(2, 6);
  for (Complex& value : data.substructures[0].values) value = 0.0;
  Scene scene = scene_with(Pattern::full, "qr");
  scene.identify.method = Method::two;
  const auto plan = data.plan(scene);
  const Solution solution = solve(*plan);
  EXPECT_EQ(solution.status, Status::no_equations);
  EXPECT_EQ(solution.fit.equations_dropped, 2u * 8u);
}

TEST(ZeroHertz, AnAccelerancesLineThatCannotBeConvertedIsDroppedAndCounted) {
  MemoryScene data = random_data(5, 7);
  for (auto* set : {&data.substructures[0], &data.assembly[0]}) {
    set->header.frequency_hz = {0.0, 5.0, 10.0, 15.0, 20.0};
    set->header.quantity = frf::Quantity::accelerance;
    // What a file of accelerances hands out at 0 Hz.
    for (std::size_t i = 0; i < 16; ++i) set->values[i] = std::numeric_limits<double>::quiet_NaN();
  }
  const auto plan = data.plan(scene_with(Pattern::full, "qr"));
  ASSERT_EQ(plan->lines.size(), 5u);
  const Solution solution = solve(*plan);
  EXPECT_EQ(solution.status, Status::ok);
  EXPECT_EQ(solution.fit.lines, 4u);
  EXPECT_EQ(solution.fit.equations_dropped, 16u);
  EXPECT_EQ(solution.fit.equations_used, 64u);
}

}  // namespace
}  // namespace jointid::ident
