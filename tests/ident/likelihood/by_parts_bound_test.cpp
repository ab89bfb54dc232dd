#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/eigen.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/parts/parts_covariance.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using nlohmann::json;

json golden_chain() {
  std::ifstream file(std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "sparse.json");
  if (!file) return nullptr;
  const json all = json::parse(file);
  for (const json& each : all["cases"]) {
    if (each["name"] == "chain50") return each;
  }
  return nullptr;
}

/// The chain with the references, lines and errors of the golden bound.
problems::Problem chain_of_the_bound(const json& golden) {
  problems::ManyJoints structure = problems::many_joints("chain-50");
  structure.references.clear();
  for (const json& each : golden["bound_references"])
    structure.references.push_back(structure.parts[each[0].get<std::size_t>()].dofs()[each[1].get<std::size_t>()]);
  std::vector<double> lines;
  for (std::size_t i = 0; i < structure.frequency_hz.size(); i += 2) lines.push_back(structure.frequency_hz[i]);
  structure.frequency_hz = lines;
  return problems::many_joints_problem(structure, {"chain", ""}, false);
}

/// With all substructures in one group the information is Fisher's, whose bound an independent program has; by parts it is less.
TEST(ByPartsBound, IsThatOfAnIndependentProgram) {
  const json golden = golden_chain();
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const problems::Problem problem = chain_of_the_bound(golden);
  Scene scene = problems::scene(problem);
  const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = golden["noise_level"].get<double>() / std::sqrt(3.0)};
  scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify.method = Method::likelihood;
  scene.identify.solver = Solver::by_parts;
  const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
  std::vector<double> theta;
  for (std::size_t c = 0; c < plan->columns->size(); ++c) theta.push_back(problem.unknowns[c].value / plan->unscale(c));
  const PartGroups all = part_groups(*plan, plan->equations, problem.substructures.size());
  ASSERT_EQ(all.groups.size(), 1u);
  PartsData data(*plan, all);
  data.read({});
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(at(theta.size()), at(theta.size()));
  for (const GroupLine& line : data.groups().front()) {
    const GroupImpedance impedance = group_impedance(all.groups.front(), theta, line.omega, plan->omega0);
    information += GroupLinearisation(all.groups.front(), all, line, impedance).information();
  }
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::VectorXd bound = scale.cwiseProduct((0.5 * unit.inverse()).diagonal().cwiseSqrt());
  const std::vector<double> expected = golden["bound"];
  const Eigen::Index joints = 50;
  for (Eigen::Index c = 0; c < bound.size(); ++c) {
    const Eigen::Index half = c / (3 * joints), joint = c % (3 * joints) / 3;  // K of all joints, then D; the file has joint by joint
    const double golden_bound = expected[std::size_t(6 * joint + 3 * half + c % 3)];
    EXPECT_NEAR(bound[c] * plan->unscale(std::size_t(c)) / golden_bound, 1.0, 1e-5) << problem.unknowns[std::size_t(c)].name;
  }
  const std::vector<double> eigenvalues = golden["bound_information_eigenvalues_unit_diagonal"];
  const Eigen::VectorXd found = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unit).eigenvalues();
  EXPECT_NEAR(found.minCoeff() / eigenvalues.front(), 1.0, 1e-4);
  EXPECT_NEAR(found.maxCoeff() / eigenvalues.back(), 1.0, 1e-4);
  const Solution by_parts = solve(*plan);
  ASSERT_TRUE(by_parts.unknowns.front().std_error);
  for (Eigen::Index c = 0; c < bound.size(); ++c)
    EXPECT_GT(*by_parts.unknowns[std::size_t(c)].std_error, bound[c] * plan->unscale(std::size_t(c)) * (1.0 - 1e-6));
}

}  // namespace
}  // namespace jointid::ident
