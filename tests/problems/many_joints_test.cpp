#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ident/equations/system_pattern.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

namespace jointid::problems {
namespace {

using nlohmann::json;

/// The case of an independent program, or null where its file is not there.
json golden_case(const std::string& name) { return jointid::golden_case("sparse.json", "name", name); }

ident::Control only_estimates() {
  ident::Control control;
  control.detail = ident::Detail::estimates;
  return control;
}

/// "chain-50" of golden "chain50".
class Golden : public testing::TestWithParam<const char*> {
 protected:
  static std::string golden_name() {
    std::string name = GetParam();
    name.erase(name.find('-'), 1);
    return name;
  }
};

TEST_P(Golden, PartsJointsAndFrfsOfTheAssemblyAreThoseOfAnIndependentProgram) {
  const json golden = golden_case(golden_name());
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const ManyJoints structure = many_joints(GetParam());
  const frf::FrfSet assembly = assembly_receptances(structure);
  ASSERT_EQ(structure.parts.size(), golden["parts"]);
  ASSERT_EQ(assembly.header.response.size(), golden["coordinates"]);
  ASSERT_EQ(structure.frequency_hz.size(), golden["lines_hz"].size());
  for (std::size_t i = 0; i < structure.frequency_hz.size(); ++i) EXPECT_NEAR(structure.frequency_hz[i], golden["lines_hz"][i], 1e-10);
  ASSERT_EQ(structure.references.size(), golden["references"].size());
  for (std::size_t r = 0; r < structure.references.size(); ++r) {
    const auto part = golden["references"][r][0].get<std::size_t>(), coordinate = golden["references"][r][1].get<std::size_t>();
    EXPECT_EQ(structure.references[r], structure.parts[part].dofs()[coordinate]);
  }
  for (std::size_t e = 0; e < structure.joints.size(); ++e) {
    std::vector<std::size_t> places;
    for (const frf::Dof& dof : structure.joints[e].dofs) places.push_back(frf::find_coordinate(assembly.header.response, dof));
    EXPECT_EQ(places, golden["joint_coordinates"][e].get<std::vector<std::size_t>>());
  }
  const std::size_t n = assembly.header.response.size(), middle = frf::find_coordinate(
      assembly.header.response, structure.parts[structure.parts.size() / 2].dofs()[1]);
  for (const json& probe : golden["probe"]) {
    const auto line = probe["line"].get<std::size_t>();
    const std::size_t rows[] = {0, middle, n - 1};
    const json& expected = probe["H_asm"];
    const std::size_t references = structure.references.size();
    ASSERT_EQ(expected.size(), 3 * references) << "rows one after the other";
    for (std::size_t k = 0; k < 3 * references; ++k) {
      const Complex value(expected[k][0], expected[k][1]);
      const Complex found = assembly.values[assembly.index(line, rows[k / references], k % references)];
      EXPECT_LE(std::abs(found - value), 1e-8 * std::abs(value)) << line << ", " << k;
    }
  }
}

/// Truth of the golden file: joint after joint, K then D.
std::vector<double> truth_by_joint(const Problem& problem, std::size_t joints) {
  const std::size_t each = problem.unknowns.size() / joints / 2;
  std::vector<double> out;
  for (std::size_t e = 0; e < joints; ++e) {
    for (const std::size_t first : {e * each, (joints + e) * each}) {
      for (std::size_t q = 0; q < each; ++q) out.push_back(problem.unknowns[first + q].value);
    }
  }
  return out;
}

TEST_P(Golden, NoiseFreeRowsOfThePartsGiveTheTruthBack) {
  const json golden = golden_case(golden_name());
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const Problem problem = make_many_joints(GetParam());
  const std::vector<double> truth = truth_by_joint(problem, golden["joints"]), expected = golden["truth"];
  ASSERT_EQ(truth.size(), expected.size());
  for (std::size_t u = 0; u < truth.size(); ++u) EXPECT_NEAR(truth[u] / expected[u], 1.0, 1e-14);
  for (const char* solver : {"auto", "spqr", "cholmod", "ldlt", "qr"}) {
    ident::Scene scene = problems::scene(problem);
    scene.identify.solver = ident::parse_solver(solver);
    const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
    const ident::Solution found = ident::solve(*plan, only_estimates());
    ASSERT_EQ(found.status, Status::ok) << found.message;
    EXPECT_EQ(found.fit.rank, problem.unknowns.size());
    double worst = 0.0;
    for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
      ASSERT_EQ(found.unknowns[u].name, problem.unknowns[u].name);
      worst = std::max(worst, std::abs(found.unknowns[u].value / problem.unknowns[u].value - 1.0));
    }
    EXPECT_LT(worst, 1e-8) << solver;
  }
}

TEST_P(Golden, PlanTellsTheCoupledJoints) {
  const json golden = golden_case(golden_name());
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const Problem problem = make_many_joints(GetParam());
  const auto plan = problems::plan(problems::scene(problem), {problem.substructures, problem.assembly});
  const auto pattern = ident::system_pattern(*plan, 150);
  ASSERT_TRUE(pattern);
  if (plan->scene.joints.size() == golden["joints"]) {  // in the frame joints that share coordinates are one joint of the scene
    EXPECT_EQ(pattern->joint_pairs, golden["joint_pairs_coupled_in_information_of_local_rows"]);
    for (std::size_t s = 0; s < pattern->joints_of.size(); ++s)
      EXPECT_EQ(pattern->joints_of[s], golden["joints_of_part"][s].get<std::vector<std::size_t>>());
  }
  EXPECT_LT(pattern->share_of_dense(), 0.3);
  EXPECT_EQ(ident::name(plan->solver), "spqr");
}

INSTANTIATE_TEST_SUITE_P(ManyJoints, Golden, testing::Values("chain-50", "frame-40"), [](const auto& name) {
  return std::string(name.param).substr(0, 5);
});

/// `loose-3`: the chain with three loose joints, seen by six sensors.
TEST(ManyJointsTest, TheLooseChainIsThatOfAnIndependentProgram) {
  const json golden = golden_case("chain50_loose3");
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  ManyJoints structure = many_joints("loose-3");
  const Problem problem = make_many_joints("loose-3");
  ASSERT_EQ(problem.unknowns.size(), structure.joints.size());
  for (std::size_t e = 0; e < structure.joints.size(); ++e) {
    const double lost = golden["loose"].value(std::to_string(e), 0.0);
    EXPECT_NEAR(problem.unknowns[e].value, 1.0 - lost, 1e-14);
    for (auto& row : structure.joints[e].relative_stiffness) {
      for (double& element : row) element *= 1.0 - lost;
    }
  }
  const auto dof = [&](const json& place) { return structure.parts[place[0].get<std::size_t>()].dofs()[place[1].get<std::size_t>()]; };
  structure.references.clear();
  for (const json& each : golden["references"]) structure.references.push_back(dof(each));
  structure.frequency_hz = {golden["lines_hz"][0].get<double>()};
  const frf::FrfSet assembly = assembly_receptances(structure);
  std::size_t k = 0;
  for (const json& sensor : golden["sensors"]) {
    const std::size_t row = frf::find_coordinate(assembly.header.response, dof(sensor));
    for (std::size_t c = 0; c < structure.references.size(); ++c, ++k) {
      const Complex expected(golden["H_first_line"][k][0], golden["H_first_line"][k][1]);
      EXPECT_LE(std::abs(assembly.values[assembly.index(0, row, c)] - expected), 1e-8 * std::abs(expected)) << k;
    }
  }
}

/// The hub carries every unknown: no pattern, and a dense solver.
TEST(ManyJointsTest, AStarIsDense) {
  const Problem problem = many_joints_problem(star_of_beams({.joints = 26}), {"star-26", ""}, false);
  const auto plan = problems::plan(problems::scene(problem), {problem.substructures, problem.assembly});
  EXPECT_EQ(ident::name(plan->solver), "qr");
  const auto pattern = ident::system_pattern(*plan, 150);
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->widest, pattern->unknowns);
  EXPECT_EQ(pattern->widest_file, "star-26_part_1.h5");
  const ident::Solution found = ident::solve(*plan, only_estimates());
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u)
    EXPECT_NEAR(found.unknowns[u].value / problem.unknowns[u].value, 1.0, 1e-6) << problem.unknowns[u].name;
}

/// H_ji in place of H_ij: the same numbers with forces at every coordinate and motion at a few.
frf::FrfSet transposed(const frf::FrfSet& set) {
  frf::FrfSet out = set;
  std::swap(out.header.response, out.header.reference);
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < set.header.response.size(); ++r) {
      for (std::size_t c = 0; c < set.header.reference.size(); ++c) out.values[out.index(line, c, r)] = set.values[set.index(line, r, c)];
    }
  }
  return out;
}

/// By reciprocity a row of a part for (m, l) is Method One's for (l, m): the same estimate where both are there.
TEST(ManyJointsTest, RowsByPartsAreThoseOfMethodOneByReciprocity) {
  const Problem problem = many_joints_problem(chain_of_beams({.joints = 3, .spacing = 1}), {"chain-3", ""}, false);
  ident::Scene scene = problems::scene(problem);
  const auto by_parts = problems::plan(scene, {problem.substructures, problem.assembly});
  ASSERT_TRUE(by_parts->why_by_parts);
  EXPECT_THAT(by_parts->why_by_parts->problem, testing::HasSubstr("reference"));
  const auto usual = problems::plan(scene, {problem.substructures, transposed(problem.assembly)});
  ASSERT_FALSE(usual->why_by_parts);
  const ident::Solution one = ident::solve(*usual), other = ident::solve(*by_parts);
  ASSERT_EQ(one.unknowns.size(), 18u);
  for (std::size_t u = 0; u < one.unknowns.size(); ++u) {
    EXPECT_NEAR(one.unknowns[u].value / problem.unknowns[u].value, 1.0, 1e-7);
    EXPECT_NEAR(other.unknowns[u].value / problem.unknowns[u].value, 1.0, 1e-7);
  }
  EXPECT_THAT(by_parts->notes, testing::Contains(testing::HasSubstr("balances each substructure alone")));
}

/// A sensor that points the other way in one of many parts is named by the short check, which looks at few of them closely.
TEST(ManyJointsTest, ASignAmongManyPartsIsNamed) {
  Problem problem = many_joints_problem(chain_of_beams({.joints = 20, .spacing = 2}), {"chain-20", ""}, false);
  Measurement data = polluted(problem, 1, 0);
  frf::FrfSet& wrong = data.assembly;
  const std::size_t row = 6 * 7 + 2;  // y of the middle node of part 8
  const frf::Dof turned = wrong.header.response[row];
  for (std::size_t line = 0; line < wrong.header.lines(); ++line) {
    for (std::size_t c = 0; c < wrong.header.reference.size(); ++c) wrong.values[wrong.index(line, row, c)] *= -1.0;
  }
  const auto plan = problems::plan(problems::scene(problem), std::move(data));
  ident::Control control;
  control.judgement = ident::Judgement::data;
  const ident::Solution found = ident::solve(*plan, control);
  ASSERT_TRUE(found.check);
  ASSERT_FALSE(found.check->suspects.empty());
  EXPECT_EQ(found.check->suspects.front().kind, ident::SuspectKind::sign);
  ASSERT_EQ(found.check->suspects.front().dofs.size(), 1u);
  EXPECT_EQ(found.check->suspects.front().dofs.front(), turned);
  const auto clean = problems::plan(problems::scene(problem), polluted(problem, 1, 0));
  EXPECT_EQ(ident::solve(*clean, control).check->verdict, ident::Verdict::clean);
}

}  // namespace
}  // namespace jointid::problems
