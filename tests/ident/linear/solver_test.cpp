#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/real_lu.hpp"
#include "dense/svd.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/identify.hpp"
#include "minimise/linear/column_scaling.hpp"
#include "plain_estimate.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/thesis_beams.hpp"
#include "problems/problem.hpp"

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
  const auto dof = [](std::size_t node) {
    return frf::Dof{.node = static_cast<std::int64_t>(node), .direction = frf::Direction::x};
  };
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
  scene.identify.solver = parse_solver(solver);
  const auto plan = chain.plan(scene);
  return solve(*plan);
}

std::vector<double> values(const Solution& solution) {
  std::vector<double> out;
  for (const Estimate& estimate : solution.unknowns) out.push_back(estimate.value);
  return out;
}

/// Orthogonal solvers, QR of all equations at once among them, agree to this times the condition number, the normal equations
/// with them to this times its square. Up to 6 of these 64 units were seen.
constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();

/// Differences are held against the largest unknown.
void expect_equal(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  double largest = 0.0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t u = 0; u < expected.size(); ++u) EXPECT_NEAR(found[u], expected[u], tolerance * largest) << "unknown " << u;
}

void expect_equal(const Solution& one, const Solution& two, double tolerance) {
  ASSERT_EQ(one.unknowns.size(), two.unknowns.size());
  for (std::size_t u = 0; u < one.unknowns.size(); ++u) EXPECT_EQ(one.unknowns[u].name, two.unknowns[u].name);
  expect_equal(values(one), values(two), tolerance);
}

/// The coefficients of a scene's reduced system, all triangles below each other, columns scaled as the solvers do.
Eigen::MatrixXd stacked_triangles(const MemoryScene& parts) {
  const auto plan = parts.plan();
  RunTime ignored;
  Assembled assembled = assemble(*plan, ignored);
  assembled.accumulator.flush();
  const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  Eigen::MatrixXd system(0, index(assembled.accumulator.columns()));
  for (const auto& [columns, triangle] : assembled.accumulator.triangles()) {
    const Eigen::Index before = system.rows();
    system.conservativeResize(before + index(columns.size()), Eigen::NoChange);
    system.bottomRows(index(columns.size())).setZero();
    for (std::size_t j = 0; j < columns.size(); ++j) {
      for (std::size_t i = 0; i <= j; ++i) system(before + index(i), index(columns[j])) = triangle(i, j);
    }
  }
  return system * minimise::power_of_two_scales(system).asDiagonal();
}

double condition(const Eigen::MatrixXd& system) {
  const Eigen::VectorXd sigma = dense::jacobi_svd(system, dense::Vectors::none, dense::Vectors::none).sigma;
  return sigma[0] / sigma[sigma.size() - 1];
}

/// ‖A‖₁‖A⁻¹‖₁
double one_norm_condition(const Eigen::MatrixXd& a) {
  const auto norm = [](const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); };
  return norm(a) * norm(dense::RealLu(a).solve(Eigen::MatrixXd::Identity(a.rows(), a.cols())));
}

TEST(Solvers, AChainOfTwentyJointsIsTheSameForAllSolvers) {
  const restrictions::MatrixSpec full = Pattern::full;
  const MemoryScene parts = chain(20, full, 1);
  const Solution qr = solved(parts, "qr"), spqr = solved(parts, "spqr"), normal = solved(parts, "normal");
  EXPECT_EQ(qr.used.solver + spqr.used.solver + normal.used.solver, "qrspqrnormal");
  for (const Solution* each : {&qr, &spqr, &normal}) EXPECT_EQ(each->status, Status::ok) << each->message;
  expect_equal(spqr, qr, rounding * qr.fit.condition);
  expect_equal(normal, qr, rounding * qr.fit.condition * qr.fit.condition);
}

/// qr tells σ₁/σ_n. The pivots of spqr are a bound from below, near it where columns are nearly orthogonal as here. The normal
/// equations tell the root of their condition in the 1-norm, of which LAPACK's estimate is hardly ever less than a third.
TEST(Solvers, TheConditionOfAChainIsWhatEverySolverSaysItIs) {
  const MemoryScene parts = chain(20, Pattern::full, 1);
  const Eigen::MatrixXd system = stacked_triangles(parts);
  const double exact = condition(system), one_norm = one_norm_condition(system.transpose() * system);
  EXPECT_NEAR(solved(parts, "qr").fit.condition / exact, 1.0, 1e-12);
  const double pivots = solved(parts, "spqr").fit.condition;
  EXPECT_LE(pivots, exact * (1.0 + 1e-12));
  EXPECT_GE(pivots, exact / 1.5);
  const double normal = solved(parts, "normal").fit.condition;
  EXPECT_LE(normal, std::sqrt(one_norm) * (1.0 + 1e-12));
  EXPECT_GE(normal, std::sqrt(one_norm / 3.0));
}

TEST(Solvers, AChainOfTwentyJointsEqualsThePlainRoute) {
  MemoryScene parts = chain(20, Pattern::full, 1);
  parts.scene.identify.equations = {Equation::nj};  // the plain route takes 1600 coefficients per equation
  parts.scene.identify.solver = Solver::spqr;
  parts.scene.frequency.range_hz = {{14.0, 35.0}};
  const auto plan = parts.plan();
  ASSERT_GT(linear_plan(*plan)->spec.supports.size(), 1u);  // split by substructure
  const Solution spqr = solve(*plan);
  expect_equal(values(spqr), PlainEstimate(*plan, parts.substructures, parts.assembly).solve(), rounding * spqr.fit.condition);
}

TEST(Solvers, ManyJointsAreSolvedBySpqrWithoutBeingAsked) {
  const MemoryScene parts = chain(60, Pattern::full, 2);
  const Solution chosen = solved(parts, "auto");
  EXPECT_EQ(chosen.used.solver, "spqr");
  EXPECT_EQ(chosen.unknowns.size(), 240u);
  const Solution qr = solved(parts, "qr");
  expect_equal(chosen, qr, rounding * qr.fit.condition);
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
  const Solution qr = solved(parts, "qr");
  expect_equal(solved(parts, "spqr"), qr, rounding * qr.fit.condition);
  expect_equal(values(solve(*plan)), PlainEstimate(*plan, parts.substructures, parts.assembly).solve(),
               rounding * qr.fit.condition);
}

TEST(Solvers, NormalEquationsOfCaseA1AreCloseToTheOthers) {
  const problems::Problem a1 = problems::make("A1");
  Scene scene = problems::scene(a1);
  std::vector<Solution> solutions;
  for (const char* solver : {"qr", "spqr", "normal"}) {
    scene.identify.solver = parse_solver(solver);
    const auto plan = problems::plan(scene, problems::polluted(a1, 1, 0));
    solutions.push_back(solve(*plan));
  }
  const double condition = solutions[0].fit.condition;
  EXPECT_LE(solutions[1].fit.condition, condition * (1.0 + rounding));  // a bound from below by pivots
  expect_equal(solutions[1], solutions[0], rounding * condition);
  expect_equal(solutions[2], solutions[0], rounding * condition * condition);
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
  const double tolerance = rounding * both.fit.condition * 1e6;  // N/m, the largest element
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
        for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(found[i][j], expected[i][j], tolerance) << i << j;
      }
    }
  }
}

TEST(Bands, ColumnsAreNamedByTheirBand) {
  const problems::Problem a9 = problems::make("A9");
  const auto plan =
      problems::plan(with_bands(problems::scene(a9), {{400.0, 602.5}, {602.5, 1001.0}}), {a9.substructures, a9.assembly});
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
    scene.identify.solver = parse_solver(solver);
    const auto plan = problems::plan(scene, {a9.substructures, a9.assembly});
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::rank_deficient);
    EXPECT_EQ(solution.fit.rank, 8u);
    EXPECT_TRUE(std::isinf(solution.fit.condition));
    ASSERT_EQ(solution.unknowns.size(), 16u);
    for (std::size_t u = 0; u < 16; ++u) {
      EXPECT_EQ(solution.unknowns[u].determined, u % 2 == 0) << solver << " " << solution.unknowns[u].name;
      const double truth = a9.unknowns[u / 2].value;
      EXPECT_NEAR(solution.unknowns[u].value, u % 2 == 0 ? truth : 0.0, 1e-12 * 662400.0);  // FRFs without noise
    }
    EXPECT_NE(solution.message.find("K.a@2000-3000Hz is free"), std::string::npos) << solution.message;
  }
}

}  // namespace
}  // namespace jointid::ident
