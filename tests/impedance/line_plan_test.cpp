#include "impedance/line_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impedance/check_lines.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "problems/lines/line_problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::impedance {
namespace {

LineScene written(const problems::LineProblem& problem, const std::string& scene, const TestFolder& folder) {
  problems::LineProblem own = problem;
  own.scene = scene;
  problems::write(own, folder, {.clean = true});  // the noise is in the sets already
  return parse_line_scene(own.scene, folder / (own.name + ".toml"));
}

/// H of a structure with a mass more at a DOF.
void add_mass(frf::FrfSet& set, const std::string& dof, double mass) {
  const frf::FrfHeader& header = set.header;
  const frf::Dof at = frf::Dof::parse(dof);
  const std::size_t r = frf::find_coordinate(header.response, at), c = frf::find_coordinate(header.reference, at);
  for (std::size_t line = 0; line < header.frequency_hz.size(); ++line) {
    const double omega = 2.0 * std::numbers::pi * header.frequency_hz[line];
    const Complex z = -omega * omega * mass, held = z / (1.0 + z * set.values[set.index(line, r, c)]);
    std::vector<Complex> row, column;
    for (std::size_t k = 0; k < header.reference.size(); ++k) row.push_back(set.values[set.index(line, r, k)]);
    for (std::size_t k = 0; k < header.response.size(); ++k) column.push_back(set.values[set.index(line, k, c)]);
    for (std::size_t i = 0; i < column.size(); ++i) {
      for (std::size_t k = 0; k < row.size(); ++k) set.values[set.index(line, i, k)] -= column[i] * held * row[k];
    }
  }
}

TEST(LinePlans, CountWhatALineHas) {
  const TestFolder folder;
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), 1);
  const LineScene scene = written(problem, problem.scene, folder);
  const LinePlan plan = plan_lines(scene, false);
  std::size_t frfs = 0;
  for (const auto& [block, count] : plan.blocks) frfs += count;
  EXPECT_EQ(frfs, 14U);  // two parts of two DOFs and their assembly of four, one of each reciprocal pair: 2 × 2 + 10
  ASSERT_EQ(plan.elements.size(), 1U);
  EXPECT_EQ(plan.elements[0].name, "z(1,1)");
  EXPECT_EQ(plan.freedom, identify_lines(scene).ways[0].lines[0]->freedom);
  EXPECT_FALSE(plan.bound.has_value());
}

TEST(LinePlans, BoundOfExactFrfsIsTheScatterOfNoisyOnes) {
  const TestFolder folder;
  problems::LineProblem exact = problems::make_line_problem("isolator-zener");
  const LineScene scene = written(exact, exact.scene + "\n[noise]\nmodel = \"circular\"\nlevel = 0.01\n", folder);
  const LinePlan plan = plan_lines(scene, true);
  double squares = 0.0, count = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const problems::LineProblem data = problems::polluted(exact, seed);
    LineScene plain = parse_line_scene(data.scene, "s.toml");
    plain.laws.clear();
    const IdentifiedLines found = identify_lines(plain, data.substructures, data.assembly);
    for (std::size_t i = 0; i < found.frequency_hz.size(); ++i) {
      squares += std::norm(found.ways[0].lines[i]->z(0) - exact.truth[i][0]) / plan.bound->likelihood.lines[i]->variance(0);
      count += 1.0;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.05);  // 1,640 complex numbers: ± 0.013
}

TEST(LineChecks, CleanDataAreClean) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TestFolder folder;
    const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), seed);
    const ident::CheckResult found = check_lines(written(problem, problem.scene, folder));
    EXPECT_EQ(found.verdict, ident::Verdict::clean) << seed;
  }
}

TEST(LineChecks, AMasslessJointThatHasAMassIsNamed) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TestFolder folder;
    problems::LineProblem problem = problems::make_line_problem("isolator-zener");
    add_mass(problem.assembly.front(), "3:+Y", 0.5);
    problem = problems::polluted(problem, seed);
    const ident::CheckResult found = check_lines(written(problem, problem.scene, folder));
    ASSERT_EQ(found.suspects.size(), 1U) << seed;
    EXPECT_NE(found.suspects[0].evidence.find("contradict structure \"massless\""), std::string::npos) << found.suspects[0].evidence;
  }
}

TEST(LineChecks, AGainOfOneSensorIsNamed) {
  const TestFolder folder;
  problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), 3);
  frf::FrfSet& assembly = problem.assembly.front();
  const std::size_t row = frf::find_coordinate(assembly.header.response, frf::Dof::parse("3:+Y"));
  for (std::size_t line = 0; line < assembly.header.frequency_hz.size(); ++line) {
    for (std::size_t c = 0; c < assembly.header.reference.size(); ++c) assembly.values[assembly.index(line, row, c)] *= 1.1;
  }
  const ident::CheckResult found = check_lines(written(problem, problem.scene, folder));
  ASSERT_FALSE(found.suspects.empty());
  EXPECT_EQ(found.suspects[0].kind, ident::SuspectKind::gain);
}

TEST(LineChecks, WhatNothingCanContradictIsANote) {
  const TestFolder folder;
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), 1);
  std::string text = problem.scene + "\n[identify]\nequations = [\"jj\"]\n";
  text.replace(text.find("\"massless\""), 10, "\"symmetric\"");
  const ident::CheckResult found = check_lines(written(problem, text, folder));
  EXPECT_TRUE(found.suspects.empty());
  ASSERT_FALSE(found.notes.empty());
  EXPECT_NE(found.notes.back().find("Nothing can contradict"), std::string::npos);
}

}  // namespace
}  // namespace jointid::impedance
