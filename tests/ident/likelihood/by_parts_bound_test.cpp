#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "tasks/bound_report.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using nlohmann::json;

json golden_structure(const std::string& name) { return jointid::golden_case("sparse.json", "name", name); }

/// A structure with the references and lines of its golden bound.
problems::ManyJoints structure_of_bound(const json& golden, const std::string& name) {
  problems::ManyJoints out = problems::many_joints(name);
  out.references.clear();
  for (const json& each : golden["bound_references"])
    out.references.push_back(out.parts[each[0].get<std::size_t>()].dofs()[each[1].get<std::size_t>()]);
  if (golden["bound_lines"] == "all") return out;
  std::vector<double> lines;
  for (std::size_t i = 0; i < out.frequency_hz.size(); i += 2) lines.push_back(out.frequency_hz[i]);
  out.frequency_hz = lines;
  return out;
}

/// E|e|² = (level |H|)²/3 for every FRF.
Scene scene_of_bound(const problems::Problem& problem, double level) {
  Scene scene = problems::scene(problem);
  const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = level / std::sqrt(3.0)};
  scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  return scene;
}

class GoldenBound : public testing::TestWithParam<const char*> {};

TEST_P(GoldenBound, IsThatOfAnIndependentProgram) {
  const std::string name = GetParam();
  const json golden = golden_structure(name == "chain-50" ? "chain50" : "frame40");
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const problems::Problem problem = problems::many_joints_problem(structure_of_bound(golden, name), {name, ""}, false);
  const Scene scene = scene_of_bound(problem, golden["noise_level"]);
  const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
  const tasks::BoundReport found = tasks::predict_bound(*plan, {}, {});
  const std::vector<double> expected = golden["bound"];
  ASSERT_EQ(found.unknowns.size(), expected.size());
  const std::size_t joints = golden["joints"], each = expected.size() / joints / 2;
  for (std::size_t u = 0; u < expected.size(); ++u) {
    const std::size_t half = u / (each * joints), joint = u % (each * joints) / each;  // K of all joints, then D; the file: joint by joint
    EXPECT_NEAR(found.unknowns[u].bound / expected[2 * each * joint + each * half + u % each], 1.0, 1e-6) << found.unknowns[u].name;
  }
  EXPECT_EQ(found.lines, plan->lines.size());
  EXPECT_EQ(found.variances, std::vector<std::string>{"the law of [noise]"});
  EXPECT_EQ(found.without_lines.size(), std::min<std::size_t>(10, plan->lines.size()));
}

INSTANTIATE_TEST_SUITE_P(ByParts, GoldenBound, testing::Values("chain-50", "frame-40"), [](const auto& name) {
  return std::string(name.param).substr(0, 5);
});

problems::Problem short_chain() {
  return problems::many_joints_problem(problems::chain_of_beams({.joints = 3, .spacing = 1}), {"chain", ""}, false);
}

/// The FRFs are those that the joint gives: noise of what was measured does not make the joint look better determined than it is.
TEST(ByPartsBound, HardlyChangesWithNoiseOfTheFrfs) {
  const problems::Problem problem = short_chain();
  Scene scene = scene_of_bound(problem, 0.02);
  scene.identify.solver = Solver::by_parts;
  scene.identify.method = Method::likelihood;
  const auto of = [&](problems::Measurement sets) { return tasks::predict_bound(*problems::plan(scene, std::move(sets)), {}, {}); };
  const tasks::BoundReport exact = of({problem.substructures, problem.assembly}), noisy = of(problems::polluted(problem, 1, 0));
  for (std::size_t u = 0; u < exact.unknowns.size(); ++u)
    EXPECT_NEAR(noisy.unknowns[u].bound / exact.unknowns[u].bound, 1.0, 0.1) << exact.unknowns[u].name;
}

TEST(ByPartsBound, IsNotAboveTheErrorsStated) {
  const problems::Problem problem = short_chain();
  Scene scene = scene_of_bound(problem, 0.02);
  scene.identify.solver = Solver::by_parts;
  scene.identify.method = Method::likelihood;
  const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
  const Solution found = solve(*plan);
  const tasks::BoundReport bound = tasks::predict_bound(*plan, {}, {});
  for (std::size_t u = 0; u < bound.unknowns.size(); ++u)
    EXPECT_GT(found.unknowns[u].std_error.value(), bound.unknowns[u].bound * (1.0 - 1e-6)) << bound.unknowns[u].name;
}

TEST(ByPartsBound, CandidatesAreRefused) {
  const problems::Problem problem = short_chain();
  Scene scene = scene_of_bound(problem, 0.02);
  scene.identify.solver = Solver::by_parts;
  scene.identify.method = Method::likelihood;
  const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
  try {
    tasks::predict_bound(*plan, {frf::Dof::parse("2:+Y")}, {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(error.parts().remedy.find("gauss-helmert"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace jointid::ident
