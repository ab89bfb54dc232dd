#include "ident/newton/newton.hpp"

#include <gmock/gmock.h>

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/newton/iteration.hpp"
#include "ident/result/minima.hpp"
#include "minimise/least_squares.hpp"
#include "minimise/linear/start_points.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using testing::HasSubstr;
using testing::Le;

Control one_thread() {
  Control control;
  control.threads = 1;
  return control;
}

/// Case H4 of thesis §6.12.3: only H_nn of the assembly. Fewer lines make searches without derivatives quick.
class UnreachableJoint : public testing::Test {
 protected:
  UnreachableJoint() : problem_(problems::make("H4")), scene_(problems::scene(problem_)) {
    for (const problems::ExactUnknown& unknown : problem_.unknowns) truth_.push_back(unknown.value);
  }

  Solution solve(const Scene& scene, problems::Measurement data) const {
    return ident::solve(*problems::plan(scene, std::move(data)), one_thread());
  }
  /// Interrupted after it asked so often; returns how often it asked.
  int solve_until(const Scene& scene, int most) const {
    std::atomic<int> asked = 0;
    Control control = one_thread();
    control.interrupted = [&asked, most] { return ++asked > most; };
    ident::solve(*problems::plan(scene, {problem_.substructures, problem_.assembly}), control);
    return asked;
  }
  Solution solve(const Scene& scene) const { return solve(scene, {problem_.substructures, problem_.assembly}); }

  /// The start `factor` times the truth.
  Scene near(double factor) const {
    Scene scene = scene_;
    scene.identify.start = scene_.truth;
    for (auto& row : scene.identify.start.at(restrictions::Kind::stiffness)) {
      for (double& value : row) value *= factor;
    }
    return scene;
  }

  double largest_error(const Solution& solution) const {
    double largest = 0.0;
    for (std::size_t u = 0; u < truth_.size(); ++u)
      largest = std::max(largest, std::abs(solution.unknowns[u].value / truth_[u] - 1.0));
    return largest;
  }

  problems::Problem problem_;
  Scene scene_;
  std::vector<double> truth_;
};

/// One line of random FRFs with reciprocity, 5 non-joint and 3 joint coordinates.
ResponseLine random_line(const restrictions::Restriction& restriction, const UnknownColumns& columns, unsigned seed) {
  std::srand(seed);
  const Eigen::MatrixXcd h = Eigen::MatrixXcd::Random(8, 8);
  ReachableFrfs frfs = {h.topLeftCorner(5, 5), h.topRightCorner(5, 3), h.bottomLeftCorner(3, 5), h.bottomRightCorner(3, 3),
                        Eigen::MatrixXcd::Random(5, 5)};
  frfs.nn(2, 3) = std::nan("");
  return {std::move(frfs), joint_at(restriction, columns, 3.0, 2.0)};
}

restrictions::JointSpec full_joint() {
  restrictions::JointSpec joint;
  joint.dofs = {frf::Dof::parse("1:+X"), frf::Dof::parse("2:+X"), frf::Dof::parse("3:+X")};
  joint.matrices[restrictions::Kind::stiffness] = restrictions::Pattern::full;
  joint.matrices[restrictions::Kind::hysteretic_damping] = restrictions::Pattern::full;
  return joint;
}

TEST(ResponseLine, ItsJacobianIsThatOfCentralDifferences) {
  const restrictions::JointSpec joint = full_joint();
  const restrictions::Restriction restriction = restrictions::build({joint});
  const UnknownColumns columns(restriction, {joint});
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ResponseLine line = random_line(restriction, columns, seed);
    ASSERT_EQ(line.rows(), 48u);  // 25 entries less one, real and imaginary
    const Eigen::VectorXd start = Eigen::VectorXd::Random(18);
    std::vector<double> theta(start.begin(), start.end()), f(48), before(48), after(48), jacobian(48 * 18);
    ASSERT_TRUE(line.linearise(theta, f.data(), jacobian.data()));
    const double scale = Eigen::Map<Eigen::VectorXd>(jacobian.data(), 48 * 18).cwiseAbs().maxCoeff();
    for (std::size_t t = 0; t < 18; ++t) {
      const double middle = theta[t];
      theta[t] = middle + 1e-5;
      line.residual(theta, after.data());
      theta[t] = middle - 1e-5;
      line.residual(theta, before.data());
      theta[t] = middle;
      for (std::size_t row = 0; row < 48; ++row) {
        EXPECT_NEAR(jacobian[row * 18 + t], (after[row] - before[row]) / 2e-5, 1e-6 * scale) << seed << ' ' << row << ' ' << t;
      }
    }
  }
}
/// Within a step of any minimiser, of other libraries too.
TEST_F(UnreachableJoint, EndsWhereItIsInterrupted) {
  for (const Solver solver : {Solver::automatic, Solver::newton, Solver::ceres, Solver::pattern}) {
    Scene scene = near(1.5);
    scene.identify.solver = solver;
    for (const int most : {3, 60, 100}) EXPECT_THROW(solve_until(scene, most), Interrupted) << most;
  }
}

TEST_F(UnreachableJoint, FromTheThesisStartItIsExactInSixteenIterations) {
  for (const Method method : {Method::newton, Method::likelihood}) {
    Scene scene = scene_;
    scene.identify.method = method;
    const Solution found = solve(scene);
    EXPECT_EQ(found.status, Status::ok);
    EXPECT_LE(found.fit.iterations, 16u) << name(method);
    EXPECT_LT(largest_error(found), 1e-8) << name(method);
  }
}

/// The library that a solver needs and this build lacks, or none.
std::string missing_library(const std::string& solver) {
  if (solver == "ceres" && !minimise::has_ceres()) return "Ceres";
  if (solver == "ipopt" && !minimise::has_ipopt()) return "Ipopt";
  return "";
}

class EverySolver : public UnreachableJoint, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    if (!missing_library(GetParam()).empty()) JOINTID_SKIP("this build lacks " << missing_library(GetParam()));
  }

  bool has_derivatives() const { return GetParam() != "pattern"; }
};

TEST_P(EverySolver, FindsItFromNearby) {
  Scene scene = near(1.05);
  scene.frequency.step_hz = 60.0;
  scene.identify.solver = parse_solver(GetParam());
  const Solution found = solve(scene);
  EXPECT_EQ(found.used.solver, GetParam());
  EXPECT_EQ(found.fit.rank, truth_.size());
  if (has_derivatives()) {
    EXPECT_EQ(found.status, Status::ok) << found.message;
    EXPECT_LT(largest_error(found), 1e-6);
  } else {
    EXPECT_LT(*found.fit.asm_frf_error, 1.0);  // dB: a narrow valley, where they crawl
  }
}

INSTANTIATE_TEST_SUITE_P(Newton, EverySolver, testing::ValuesIn(names(traits(Method::newton).solvers)), [](const auto& solver) {
  std::string name = solver.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

/// The thesis: errors of 0.86 for newton, which fits H_nn without weighing its noise.
TEST_F(UnreachableJoint, NoiseMovesTheLikelihoodByLessThanAThirdAndNewtonByLessThanTwice) {
  const problems::Measurement noisy = problems::polluted(problem_, 1, 0);
  Scene scene = scene_;
  const Solution newton = solve(scene, noisy);
  EXPECT_LT(largest_error(newton), 2.0);
  EXPECT_LT(*newton.fit.asm_frf_error, 3.0);  // dB, what the noise of 5 % leaves
  scene.identify.method = Method::likelihood;
  EXPECT_LT(largest_error(solve(scene, noisy)), 0.3);
}

TEST_F(UnreachableJoint, ManyStartsTellTheirMinimaAndThatTheBestIsUnique) {
  Scene scene = scene_;
  scene.frequency.step_hz = 20.0;
  for (const Method method : {Method::newton, Method::likelihood}) {
    scene.identify.method = method;
    scene.identify.starts = 6;
    const Solution found = solve(scene);
    ASSERT_TRUE(found.search.has_value());
    std::size_t starts = 0;
    for (const FoundMinimum& minimum : found.search->minima) {
      starts += minimum.starts;
      EXPECT_LE(found.search->minima.front().cost, minimum.cost);
    }
    EXPECT_LE(starts, 6u);
    EXPECT_GE(found.search->minima.front().starts, 2u) << name(method);
    EXPECT_EQ(found.search->equally_good, 1u) << name(method);
    for (std::size_t u = 0; u < truth_.size(); ++u) {
      EXPECT_NEAR(found.search->minima.front().values[u] / truth_[u], 1.0, 1e-6) << name(method);
    }
  }
}

TEST_F(UnreachableJoint, AColumnWithoutEffectIsToldByTheRank) {
  Scene scene = scene_;
  scene.joints.front().matrices[restrictions::Kind::mass] = scene.joints.front().matrices.at(restrictions::Kind::stiffness);
  scene.frequency.range_hz = Range{500.0, 500.0};  // K − ω²M on one line: K and M move together
  scene.frequency.step_hz.reset();
  const Solution found = solve(scene);
  EXPECT_EQ(found.status, Status::rank_deficient);
  EXPECT_EQ(found.fit.rank, truth_.size());
}

TEST_F(UnreachableJoint, LinesThatAreNotMeasuredAreLeftOutAndNoneIsAnAnswer) {
  problems::Measurement data = {problem_.substructures, problem_.assembly};
  for (std::size_t i = 0; i < data.assembly.values.size() / 2; ++i) data.assembly.values[i] = std::nan("");
  EXPECT_LT(largest_error(solve(scene_, data)), 1e-8);
  for (auto& value : data.assembly.values) value = std::nan("");
  EXPECT_EQ(solve(scene_, data).status, Status::no_equations);
}

TEST_F(UnreachableJoint, WhatItCannotDoItSaysBeforeItReads) {
  const auto message = [&](const Scene& scene) -> std::string {
    try {
      problems::plan(scene, {problem_.substructures, problem_.assembly});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Scene scene = scene_;
  scene.identify.solver = Solver::qr;
  EXPECT_THAT(message(scene), HasSubstr("use auto, levenberg-marquardt, newton,"));
  scene = scene_;
  scene.identify.equations = {Equation::nj};
  EXPECT_THAT(message(scene), HasSubstr("uses the equation nn only"));
  scene = scene_;
  scene.identify.method = Method::one;
  EXPECT_THAT(message(scene), HasSubstr("needs no start"));
  scene = scene_;
  scene.identify.priors.push_back({"K(1,1)", 1.0, 1.0});
  EXPECT_THAT(message(scene), HasSubstr("has no use for priors"));
}

TEST_F(UnreachableJoint, WithoutAStartItBeginsAtTheDirectSolution) {
  Scene scene = scene_;
  scene.identify.start.clear();
  const Solution found = solve(scene);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_LT(largest_error(found), 1e-8);
}

TEST(StartPoints, SizesThatFitComeFirstThenRandomOnesWithin80Percent) {
  const minimise::StartPoints starts({{2.0, -4.0}}, [](const std::vector<double>& theta) { return std::abs(theta[0] - 200.0); });
  EXPECT_DOUBLE_EQ(starts(0)[0], 200.0);
  EXPECT_DOUBLE_EQ(starts(0)[1], -400.0);
  for (std::size_t k = minimise::StartPoints::sizes; k < 100; ++k) {
    EXPECT_THAT(std::abs(starts(k)[0] - 200.0), Le(160.0));
    EXPECT_THAT(std::abs(starts(k)[1] + 400.0), Le(320.0));
    EXPECT_EQ(starts(k), starts(k));
    EXPECT_NE(starts(k), starts(k + 1));
  }
}

TEST(StartPoints, SizesOfSeveralGuessesAreRankedTogether) {
  const auto misfit = [](const std::vector<double>& theta) { return std::abs(theta[0] - 200.0) + std::abs(theta[1] - 10.0); };
  const minimise::StartPoints starts({{2.0, -4.0}, {2.0, 0.1}}, misfit);
  EXPECT_DOUBLE_EQ(starts(0)[1], 10.0);
  for (std::size_t k = 1; k < 2 * minimise::StartPoints::sizes; ++k) EXPECT_LE(misfit(starts(k - 1)), misfit(starts(k)));
}

TEST(MinimumList, EndsOfOneMinimumAreOneAndTheBestIsFirst) {
  const auto same = [](const FoundMinimum& a, const FoundMinimum& b) { return std::abs(a.values[0] - b.values[0]) < 0.1; };
  MinimumList list;
  for (const auto& [cost, value] : {std::pair(3.0, 1.0), {2.9, 1.05}, {1.0, 7.0}, {1.1, 9.0}}) list.add({cost, 1, {value}}, same);
  const MinimumSearch found = list.result(1.5);
  ASSERT_EQ(found.minima.size(), 3u);
  EXPECT_EQ(found.minima[0].values[0], 7.0);
  EXPECT_EQ(found.minima[2].starts, 2u);
  EXPECT_EQ(found.minima[2].cost, 2.9);
  EXPECT_EQ(found.equally_good, 2u);
}

}  // namespace
}  // namespace jointid::ident
