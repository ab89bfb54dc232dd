#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ident/solve.hpp"
#include "plain_estimate.hpp"
#include "problems/in_memory.hpp"
#include "problems/thesis_beams.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;

/// Substructures 0 … count in a chain: structure s has the DOFs 10s+1 (non-joint), 10s+2 and 10s+3 (to s−1 and s+1), random
/// FRFs, and between neighbours a joint of two DOFs.
MemoryScene chain(std::size_t joints, const restrictions::MatrixSpec& spec, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> lines;
  for (int i = 1; i <= 8; ++i) lines.push_back(7.0 * i);
  MemoryScene chain;
  Dofs all;
  const auto dof = [](std::size_t node) { return frf::Dof{.node = static_cast<std::int64_t>(node), .direction = frf::Direction::x}; };
  for (std::size_t s = 0; s <= joints; ++s) {
    const Dofs own = {dof(10 * s + 1), dof(10 * s + 2), dof(10 * s + 3)};
    all = joined(all, own);
    chain.substructures.push_back(random_set("part" + std::to_string(s), lines, own, own, 1.0, random));
    if (s == joints) break;
    restrictions::JointSpec joint = joint_of({dof(10 * s + 3), dof(10 * s + 12)}, Kind::stiffness, spec);
    joint.name = "j" + std::to_string(s);
    chain.scene.joints.push_back(joint);
  }
  chain.assembly = {random_set("assembly", lines, all, all, 1.0, random)};
  return chain;
}

Solution solved(const MemoryScene& chain, const std::string& solver) {
  Scene scene = chain.scene;
  scene.identify.solver = solver;
  const auto plan = chain.plan(scene);
  return solve(*plan);
}

void expect_equal(const Solution& one, const Solution& two, double tolerance) {
  ASSERT_EQ(one.unknowns.size(), two.unknowns.size());
  double largest = 0.0;
  for (const Estimate& estimate : one.unknowns) largest = std::max(largest, std::abs(estimate.value));
  for (std::size_t u = 0; u < one.unknowns.size(); ++u) {
    EXPECT_EQ(one.unknowns[u].name, two.unknowns[u].name);
    EXPECT_LE(std::abs(one.unknowns[u].value - two.unknowns[u].value), tolerance * largest) << one.unknowns[u].name;
  }
}

TEST(Solvers, AChainOfTwentyJointsIsTheSameForAllSolvers) {
  const restrictions::MatrixSpec full = Pattern::full;
  const MemoryScene parts = chain(20, full, 1);
  const Solution qr = solved(parts, "qr"), spqr = solved(parts, "spqr"), normal = solved(parts, "normal");
  EXPECT_EQ(qr.used.solver + spqr.used.solver + normal.used.solver, "qrspqrnormal");
  for (const Solution* each : {&qr, &spqr, &normal}) EXPECT_EQ(each->status, Status::ok) << each->message;
  expect_equal(qr, spqr, 1e-10);
  expect_equal(qr, normal, 1e-6);
  EXPECT_NEAR(spqr.fit.condition / qr.fit.condition, 1.0, 0.95);  // a bound from below by pivots
}

TEST(Solvers, AChainOfTwentyJointsEqualsThePlainRoute) {
  MemoryScene parts = chain(20, Pattern::full, 1);
  parts.scene.identify.equations = {Equation::nj};  // the plain route takes 1600 coefficients per equation
  parts.scene.identify.solver = "spqr";
  parts.scene.frequency.range_hz = {{14.0, 35.0}};
  const auto plan = parts.plan();
  ASSERT_GT(plan->assembly_spec.supports.size(), 1u);  // split by substructure
  const Solution spqr = solve(*plan);
  const std::vector<double> plain = PlainEstimate(*plan, parts.substructures, parts.assembly).solve();
  double largest = 0.0;
  for (const double value : plain) largest = std::max(largest, std::abs(value));
  for (std::size_t u = 0; u < plain.size(); ++u) EXPECT_NEAR(spqr.unknowns[u].value, plain[u], 1e-10 * largest);
}

TEST(Solvers, ManyJointsAreSolvedBySpqrWithoutBeingAsked) {
  const MemoryScene parts = chain(60, Pattern::full, 2);
  const Solution chosen = solved(parts, "auto");
  EXPECT_EQ(chosen.used.solver, "spqr");
  EXPECT_EQ(chosen.unknowns.size(), 240u);
  expect_equal(chosen, solved(parts, "qr"), 1e-10);
  EXPECT_EQ(solved(chain(3, Pattern::full, 2), "auto").used.solver, "qr");
}

TEST(Solvers, TheSplitPlanCostsLessAndFindsSpringsOfAChain) {
  MemoryScene parts = chain(24, Pattern::diagonal, 3);
  parts.scene.identify.equations = {Equation::nj};
  parts.scene.frequency.range_hz = {{14.0, 28.0}};
  for (auto& joint : parts.scene.joints) {
    joint.matrices[Kind::stiffness] = std::vector<restrictions::Spring>{{joint.dofs[0], joint.dofs[1]}};
  }
  const auto plan = parts.plan();
  EXPECT_LT(plan->cost.assemble_flops, plan->cost.stacked_flops);
  expect_equal(solved(parts, "qr"), solved(parts, "spqr"), 1e-10);
  const std::vector<double> plain = PlainEstimate(*plan, parts.substructures, parts.assembly).solve();
  const Solution solution = solve(*plan);
  for (std::size_t u = 0; u < plain.size(); ++u) EXPECT_NEAR(solution.unknowns[u].value, plain[u], 1e-10);
}

TEST(Solvers, NormalEquationsOfCaseA1AreCloseToTheOthers) {
  const problems::Problem a1 = problems::make("A1");
  Scene scene = problems::scene(a1);
  std::vector<Solution> solutions;
  for (const char* solver : {"qr", "spqr", "normal"}) {
    scene.identify.solver = solver;
    const auto plan = problems::plan(scene, problems::polluted(a1, 1, 0));
    solutions.push_back(solve(*plan));
  }
  expect_equal(solutions[0], solutions[1], 1e-10);
  expect_equal(solutions[0], solutions[2], 1e-6);
}

Scene with_bands(Scene scene, const std::vector<std::array<double, 2>>& bands) {
  scene.joints[0].bands_hz = bands;
  return scene;
}

TEST(Bands, EachIsASolveOfItsOwnLines) {
  const problems::Problem a1 = problems::make("A1");
  const problems::Measurement measured = problems::polluted(a1, 3, 0);
  const Scene scene = problems::scene(a1);
  // 1000 Hz is in no band: the upper end is open.
  const auto plan = problems::plan(with_bands(scene, {{400.0, 690.0}, {690.0, 1000.0}}), measured);
  ASSERT_EQ(plan->cost.columns, 40u);
  const Solution both = solve(*plan);
  EXPECT_EQ(both.fit.lines, 30u);
  ASSERT_EQ(both.bands.size(), 2u);
  for (std::size_t band = 0; band < 2; ++band) {
    Scene one = scene;
    one.frequency.range_hz = band == 0 ? Range{400.0, 680.0} : Range{700.0, 980.0};
    const auto one_plan = problems::plan(one, measured);
    const Solution alone = solve(*one_plan);
    EXPECT_EQ(both.bands[band].band_hz, (band == 0 ? Range{400.0, 690.0} : Range{690.0, 1000.0}));
    for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
      const Matrix& expected = alone.bands[0].matrices.at(kind);
      const Matrix& found = both.bands[band].matrices.at(kind);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(found[i][j], expected[i][j], 1e-9 * 1e6) << i << j;
      }
    }
  }
}

TEST(Bands, ColumnsAreNamedByTheirBand) {
  const problems::Problem a9 = problems::make("A9");
  const auto plan = problems::plan(with_bands(problems::scene(a9), {{400.0, 602.5}, {602.5, 1001.0}}),
                                   {a9.substructures, a9.assembly});
  const Solution solution = solve(*plan);
  ASSERT_EQ(solution.unknowns.size(), 16u);
  EXPECT_EQ(solution.unknowns[0].name, "K.a@400-602.5Hz");
  EXPECT_EQ(solution.unknowns[1].name, "K.a@602.5-1001Hz");
  EXPECT_EQ(solution.fit.lines, 31u);
}

TEST(Bands, QualityCountsEveryBand) {
  const problems::Problem a9 = problems::make("A9");
  Scene scene = with_bands(problems::scene(a9), {{400.0, 700.0}, {700.0, 1001.0}});
  const problems::Measurement measured = problems::polluted(a9, 5, 0);
  const auto plan = problems::plan(scene, measured);
  const Solution solution = solve(*plan);
  double sum = 0.0;
  for (const BandMatrices& band : solution.bands) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        sum += band.matrices.at(Kind::stiffness)[i][j] / a9.truth.at(Kind::stiffness)[i][j];
      }
    }
  }
  EXPECT_NEAR(solution.quality.at(Kind::stiffness).arvf, sum / 20.0, 1e-12);
}

TEST(Bands, ABandWithoutLinesIsNotDeterminedAndTheOthersAre) {
  const problems::Problem a9 = problems::make("A9");
  for (const char* solver : {"qr", "spqr"}) {
    Scene scene = with_bands(problems::scene(a9), {{400.0, 1001.0}, {2000.0, 3000.0}});
    scene.identify.solver = solver;
    const auto plan = problems::plan(scene, {a9.substructures, a9.assembly});
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient);
    EXPECT_EQ(solution.fit.rank, 8u);
    EXPECT_TRUE(std::isinf(solution.fit.condition));
    ASSERT_EQ(solution.unknowns.size(), 16u);
    for (std::size_t u = 0; u < 16; ++u) {
      EXPECT_EQ(solution.unknowns[u].determined, u % 2 == 0) << solver << " " << solution.unknowns[u].name;
      const double truth = a9.unknowns[u / 2].value;
      EXPECT_NEAR(solution.unknowns[u].value, u % 2 == 0 ? truth : 0.0, 1e-9 * 662400.0);
    }
    EXPECT_NE(solution.message.find("K.a@2000-3000Hz is free"), std::string::npos) << solution.message;
  }
}

}  // namespace
}  // namespace jointid::ident
