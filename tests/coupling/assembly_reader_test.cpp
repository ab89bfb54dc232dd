#include "coupling/assembly_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "in_memory_parts.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/structure/response.hpp"

namespace jointid::coupling {
namespace {

using restrictions::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double tolerance = 1e-9;

/// A chain of unit masses over nodes first … first + count − 1 on springs to each other and to ground.
problems::Structure chain(int first, int count) {
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;
  for (int i = 0; i < count; ++i) {
    nodes.push_back({.id = first + i, .position = {}});
    dofs.push_back(y(first + i));
  }
  problems::Structure out(nodes, dofs);
  for (int i = 0; i < count; ++i) {
    out.add(Kind::mass, {dofs[static_cast<std::size_t>(i)]}, {{1.0 + 0.1 * i}});
    out.add(Kind::stiffness, {dofs[static_cast<std::size_t>(i)], std::nullopt}, 2e4);
    if (i > 0) out.add(Kind::stiffness, {dofs[static_cast<std::size_t>(i) - 1], dofs[static_cast<std::size_t>(i)]}, 1e5);
  }
  out.add_proportional_damping(0.02);
  return out;
}

const std::vector<double> lines_hz = {11.0, 23.0, 37.0, 52.0, 71.0};

TEST(AssemblyReader, TheCasesOfChapterFiveAreTheirDirectAssembly) {
  for (const char* name : {"coupling-A", "coupling-B", "coupling-C"}) {
    const problems::CouplingProblem problem = problems::make_coupling(name);
    const auto parts = problems::parts_of(problem, problem.parts);
    for (const Method method : {Method::gic, Method::rc, Method::grc, Method::pcc, Method::mtc}) {
      if (method == Method::rc && std::string(name) == "coupling-B") continue;  // it has ground, and pairs within a part
      const frf::FrfSet found = couple_all(parts, problem.declared(), {.method = method});
      EXPECT_EQ(found.header.response, problem.assembly.header.response) << name;
      EXPECT_LT(largest_difference(found, problem.assembly.header.response, problem.assembly), tolerance)
          << name << " by " << coupling::name(method);
    }
  }
}

TEST(AssemblyReader, WithNoiseAllMethodsAgree) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  const auto parts = problems::parts_of(problem, problems::polluted(problem, 1, 0));
  const frf::FrfSet expected = couple_all(parts, problem.declared(), {.method = Method::grc});
  EXPECT_GT(largest_difference(expected, problem.assembly.header.response, problem.assembly), 0.01);
  for (const Method method : {Method::gic, Method::rc, Method::pcc, Method::mtc}) {
    EXPECT_LT(largest_difference(couple_all(parts, problem.declared(), {.method = method}), expected.header.response, expected), tolerance);
  }
}

TEST(AssemblyReader, RemovingAPartLeavesTheOther) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-C");
  const std::vector<Part> parts = {part_of("whole", problem.assembly), part_of("one", problem.parts[0])};
  Assembly assembly;
  assembly.remove = {"one"};
  for (int k = 1; k <= 5; ++k) {
    const std::string dof = std::to_string(k) + ":+Y";
    assembly.join.push_back({placed("whole/" + dof), placed("one/" + dof)});
  }
  for (const Method method : {Method::gic, Method::grc, Method::mtc}) {
    // Part two has its coordinates 6 … 11; 1 … 5 of the whole are its 11, 10, 9, 8, 7.
    const frf::FrfSet found = couple_all(parts, assembly, {.method = method});
    // A whole minus a part is a difference of stiff numbers.
    EXPECT_LT(largest_difference(found, {y(6), y(5), y(4), y(3), y(2), y(1)}, problem.parts[1]), 1e-7) << coupling::name(method);
  }
}

TEST(AssemblyReader, AKnownJointIsThatOfTheStructure) {
  const problems::Structure one = chain(1, 3), two = chain(4, 3);
  problems::Structure whole = problems::merged(one, two);
  whole.add(Kind::stiffness, {y(3), y(4)}, 7e4);
  whole.add(Kind::viscous_damping, {y(3), y(4)}, 30.0);
  whole.add(Kind::hysteretic_damping, {y(3), y(4)}, 5e3);
  whole.add(Kind::mass, {y(3), y(4)}, {{0.3, 0.1}, {0.1, 0.4}});
  whole.add(Kind::stiffness, {y(6), std::nullopt}, 9e4);
  Assembly assembly;
  assembly.joints.push_back({.dofs = {placed("3:+Y"), placed("4:-Y")},
                             .stiffness = {7e4, 7e4, 7e4, 7e4},
                             .mass = {0.3, -0.1, -0.1, 0.4},
                             .viscous_damping = {30.0, 30.0, 30.0, 30.0},
                             .hysteretic_damping = {5e3, 5e3, 5e3, 5e3}});
  assembly.joints.push_back({.dofs = {placed("6:+Y")}, .stiffness = {9e4}, .mass = {}, .viscous_damping = {}, .hysteretic_damping = {}});
  assembly.join = {{placed("1:+Y"), placed("5:-Y")}};
  const std::vector<Part> parts = {part_of("one", receptances(one, lines_hz)), part_of("two", receptances(two, lines_hz))};
  Assembly joints_only = assembly;
  joints_only.join.clear();
  const frf::FrfSet expected = receptances(whole, lines_hz);
  for (const Method method : {Method::gic, Method::rc, Method::grc, Method::mtc}) {
    EXPECT_LT(largest_difference(couple_all(parts, joints_only, {.method = method}), whole.dofs(), expected), tolerance);
  }
  // With the condition: coupling what already has the joint is the same as doing both at once.
  const std::vector<Part> done = {part_of("whole", expected)};
  Assembly join_only;
  join_only.join = assembly.join;
  const frf::FrfSet both = couple_all(done, join_only);
  EXPECT_LT(largest_difference(couple_all(parts, assembly, {.method = Method::mtc}), both.header.response, both), tolerance);
}

TEST(AssemblyReader, AMinusSignFlipsACoordinate) {
  const problems::Structure one = chain(1, 3), two = chain(4, 3);
  Assembly plain, flipped;
  plain.join = {{placed("3:+Y"), placed("4:+Y")}};
  flipped.join = {{placed("3:+Y"), placed("4:-Y")}};
  frf::FrfSet other_way = receptances(two, lines_hz);
  for (auto* dofs : {&other_way.header.response, &other_way.header.reference}) dofs->front().sign = -1;
  for (std::size_t i = 0; i < other_way.values.size(); ++i) {
    const bool row = i / 3 % 3 == 0, column = i % 3 == 0;
    if (row != column) other_way.values[i] = -other_way.values[i];
  }
  const Part first = part_of("one", receptances(one, lines_hz));
  const frf::FrfSet expected = couple_all({first, part_of("two", receptances(two, lines_hz))}, plain);
  // The same structure, its transducer at 4 noted the other way round.
  EXPECT_LT(largest_difference(couple_all({first, part_of("two", other_way)}, plain), expected.header.response, expected), 1e-14);
  const frf::FrfSet opposite = couple_all({first, part_of("two", receptances(two, lines_hz))}, flipped);
  EXPECT_GT(largest_difference(opposite, expected.header.response, expected), 1e-3);
  for (std::size_t line = 0; line < lines_hz.size(); ++line) {  // x_3 = −x_4 turns 1 against 5
    EXPECT_NEAR(std::abs(opposite.values[opposite.index(line, 0, 3)] + expected.values[expected.index(line, 0, 3)]), 0.0,
                1e-12 * std::abs(expected.values[expected.index(line, 0, 3)]));
  }
}

TEST(AssemblyReader, WhatIsKeptAndReadIsPartOfTheWhole) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  Assembly assembly = problem.declared();
  assembly.keep = {placed("7:+Y"), placed("2:-Y")};
  const frf::FrfSet some = couple_all(problems::parts_of(problem, problem.parts), assembly, {.threads = 1});
  const frf::FrfSet all = couple_all(problems::parts_of(problem, problem.parts), problem.declared(), {.threads = 2});
  EXPECT_THAT(some.header.response, ElementsAre(y(7), y(2, -1)));
  for (const std::size_t line : {std::size_t{0}, std::size_t{100}, some.header.lines() - 1}) {
    // 7 is 4, and a minus flips.
    const Complex expected = -all.values[all.index(line, frf::find_coordinate(all.header.response, y(4)),
                                                   frf::find_coordinate(all.header.reference, y(2)))];
    EXPECT_LT(std::abs(some.values[some.index(line, 0, 1)] - expected), 1e-13 * std::abs(expected));
  }
}

TEST(AssemblyReader, ReciprocityFillsWhatWasNotMeasured) {
  const problems::Structure one = chain(1, 3), two = chain(4, 3);
  Assembly assembly;
  assembly.join = {{placed("3:+Y"), placed("4:+Y")}};
  frf::FrfSet column = problems::frequency_response(two, {.response = two.dofs(), .reference = {y(4)}, .frequency_hz = lines_hz});
  const Part first = part_of("one", receptances(one, lines_hz));
  const frf::FrfSet expected = couple_all({first, part_of("two", receptances(two, lines_hz))}, assembly);
  const frf::FrfSet found = couple_all({first, part_of("two", column, true)}, assembly);
  const std::size_t r = frf::find_coordinate(found.header.response, y(1)), c = frf::find_coordinate(found.header.reference, y(5));
  const std::size_t er = frf::find_coordinate(expected.header.response, y(1)), ec = frf::find_coordinate(expected.header.reference, y(5));
  EXPECT_LT(std::abs(found.values[found.index(2, r, c)] - expected.values[expected.index(2, er, ec)]),
            1e-13 * std::abs(expected.values[expected.index(2, er, ec)]));
  const std::size_t five = frf::find_coordinate(found.header.response, y(5));
  EXPECT_TRUE(std::isnan(found.values[found.index(2, five, c)].real()));  // H_55 of part two was never measured
}

TEST(AssemblyReader, LooksForAStopBetweenLines) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  const auto parts = problems::parts_of(problem, problem.parts);
  const StopScope::Ask stop = [] { return true; };
  const StopScope scope(&stop);
  EXPECT_THROW(couple_all(parts, problem.declared()), Interrupted);
}

std::string error_of(const std::vector<Part>& parts, const Assembly& assembly, const Options& options = {}) {
  try {
    AssemblyReader reader(parts, assembly, options, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AssemblyReader, SaysWhatIsWrong) {
  const frf::FrfSet one = receptances(chain(1, 3), lines_hz), two = receptances(chain(3, 3), lines_hz);
  const std::vector<Part> parts = {part_of("a.h5", one), part_of("b.h5", two)};
  const auto joined = [](std::vector<std::vector<std::string>> lists) {
    Assembly out;
    for (const auto& list : lists) {
      out.join.emplace_back();
      for (const std::string& text : list) out.join.back().push_back(placed(text));
    }
    return out;
  };
  EXPECT_THAT(error_of(parts, joined({{"3:+Y", "4:+Y"}})), HasSubstr("it is in a.h5 and in b.h5; name the one that is meant: \"a.h5/3:+Y\""));
  EXPECT_THAT(error_of(parts, joined({{"2:+Z", "4:+Y"}})), HasSubstr("did you mean 2:+Y?"));
  EXPECT_THAT(error_of(parts, joined({{"c.h5/2:+Y", "4:+Y"}})), HasSubstr("there is no part c.h5"));
  EXPECT_THAT(error_of(parts, joined({{"2:+Y", "4:+Y"}})), HasSubstr("the result would have it twice"));
  EXPECT_THAT(error_of(parts, joined({{"a.h5/3:+Y", "b.h5/3:+Y"}, {"a.h5/3:+Y", "b.h5/3:-Y"}})), HasSubstr("contradicts"));
  EXPECT_THAT(error_of(parts, {}), HasSubstr("nothing is coupled"));
  const Assembly good = joined({{"a.h5/3:+Y", "b.h5/3:+Y"}});
  EXPECT_THAT(error_of(parts, good), "no error");
  EXPECT_THAT(error_of(parts, good, {.method = Method::gic, .threshold = Threshold::fixed}), HasSubstr("use method \"grc\" or \"pcc\""));
  EXPECT_THAT(error_of(parts, good, {.uncertainty = true}), HasSubstr("neither variances nor coherences"));
  EXPECT_THAT(error_of(parts, joined({{"a.h5/3:+Y", "b.h5/3:+Y"}, {"1:+Y", "2:+Y"}}), {.method = Method::rc}),
              HasSubstr("cannot meet 1:+Y = 2:+Y"));
  Assembly removed = good;
  removed.remove = {"b.h"};
  EXPECT_THAT(error_of(parts, removed), HasSubstr("did you mean b.h5?"));
  EXPECT_THAT(error_of({parts[0], part_of("c.h5", receptances(chain(3, 3), {500.0}))}, joined({{"a.h5/3:+Y", "c.h5/3:+Y"}})),
              HasSubstr("no frequency line is common"));
}

}  // namespace
}  // namespace jointid::coupling
