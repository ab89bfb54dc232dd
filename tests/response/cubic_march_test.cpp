#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "friction/law/laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/orbit/orbit_figures.hpp"
#include "response/stability/solution_orbit.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/from_joints.hpp"
#include "response/time/transient.hpp"

namespace jointid::response {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

MatrixXd one(double value) { return MatrixXd::Constant(1, 1, value); }

/// ẍ + cẋ + x + k₃x³, a joint to ground.
MatrixAssembly oscillator(double damping, const Joint& joint) {
  return {{one(1.0), one(damping), one(1.0)}, one(1.0), {joint}, one(1.0)};
}

JointedStructure marched(const MatrixAssembly& all) { return from_joints(all.structure, all.w, all.joints); }

HarmonicSolution balanced(const MatrixAssembly& all, const Excitation& force, double omega, int harmonics) {
  const auto receptance = std::make_shared<MatrixReceptance>(all.structure, all.w, one(1.0), all.forces);
  return HarmonicBalance(receptance, all.joints, force, {.fixed = Harmonics::odd(harmonics).numbers()}).solve(omega);
}

/// ω = √(α + βA²) π / 2K(m), m = βA²/2(α + βA²), of ẍ + αx + βx³ = 0.
TEST(CubicMarch, FreeMotionHasThePeriodOfTheEllipticIntegral) {
  for (const double amplitude : {0.1, 1.0, 30.0}) {
    const double beta = 0.7, hard = 1.0 + beta * amplitude * amplitude, m = 0.5 * (hard - 1.0) / hard;
    const double period = 4.0 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(hard);
    ExactMarch march(marched(oscillator(0.0, {.name = "spring", .cubic = beta})),
                     ForceHistory::periodic(1.0, {1}, Eigen::MatrixXcd::Zero(1, 1)));
    march.place(0.0, VectorXd::Constant(1, amplitude), VectorXd::Zero(1), VectorXd::Zero(1));
    ASSERT_TRUE(march.march(5.0 * period));
    const Instant end = march.motion();
    EXPECT_NEAR(end.x[0] / amplitude, 1.0, 1e-11) << amplitude;
    EXPECT_LT(std::abs(end.v[0]), 1e-9 * amplitude * std::sqrt(hard)) << amplitude;
  }
}

TEST(CubicMarch, OrbitsAreThoseOfManyHarmonics) {
  const std::shared_ptr<const friction::Element> slider = friction::make_element("bilinear", std::vector{0.3, 1.0});
  const Excitation force = Excitation::single(Complex(0.0, -1.3));
  for (const Joint& joint : {Joint{.name = "spring", .cubic = 1.0}, Joint{.name = "both", .friction = slider, .cubic = 0.8}}) {
    const MatrixAssembly all = oscillator(0.1, joint);
    const HarmonicSolution solution = balanced(all, force, 0.8, 161);
    ASSERT_TRUE(solution.converged);
    const SolutionStability found = stability(all, force, solution);
    ASSERT_TRUE(found.orbit.closed);
    EXPECT_LT(found.difference, joint.friction ? 1e-5 : 1e-10) << joint.name;
    const PeriodicProblem problem = periodic_problem(all, force, 0.8, 1.0);
    const OrbitFigures figures_of = figures(problem, found.orbit, {1, 3, 5});
    for (Eigen::Index n = 0; n < 3; ++n) {
      EXPECT_LT(std::abs(figures_of.x(0, n) - solution.response(n, 0)), 1e-8 * std::abs(solution.response(0, 0))) << joint.name;
    }
    EXPECT_LT(std::abs(figures_of.work - figures_of.loss.sum() - figures_of.damping_loss), 1e-12 * figures_of.work);
  }
}

/// Three orbits at one frequency; the one between is a saddle. The product of the multipliers is e^{−cT} (Liouville).
TEST(CubicMarch, TheOrbitBetweenTurningPointsIsUnstable) {
  const double omega = 1.6, c = 0.1, p = 0.3, period = 2.0 * pi / omega;
  const MatrixAssembly all = oscillator(c, {.name = "spring", .cubic = 1.0});
  const PeriodicProblem problem = periodic_problem(all, Excitation::single(p), omega, 1.0);
  int unstable = 0;
  for (const double square : {0.04, 1.9, 2.26}) {
    const Complex x = p / Complex(1.0 - omega * omega + 0.75 * square, c * omega);
    const OrbitStart start = {
        VectorXd::Constant(1, x.real()), VectorXd::Constant(1, -omega * x.imag()), VectorXd::Zero(1), {{}}};
    const PeriodicOrbit orbit = find_orbit(problem, start);
    ASSERT_TRUE(orbit.closed);
    const double size = std::norm(figures(problem, orbit, {1}).x(0, 0));
    EXPECT_NEAR(size / square, 1.0, 0.1);
    ASSERT_EQ(orbit.multipliers.size(), 2);
    EXPECT_NEAR(std::abs(orbit.multipliers[0] * orbit.multipliers[1]) / std::exp(-c * period), 1.0, 1e-9);
    unstable += orbit.stable ? 0 : 1;
    EXPECT_EQ(orbit.stable, square != 1.9);
  }
  EXPECT_EQ(unstable, 1);
}

TEST(CubicMarch, AlgorithmOneIsOfSecondOrder) {
  const std::shared_ptr<const friction::Element> slider = friction::make_element("ren", std::vector{0.1, 1.0, 1.0});
  const MatrixAssembly all = oscillator(0.1, {.name = "both", .friction = slider, .cubic = 2.0});
  const ForceHistory force = ForceHistory::half_sine(VectorXd::Constant(1, 3.0), 1.0);
  TransientRequest request = {.duration = 4.0, .step = 0.5, .responses = one(1.0)};
  const Transient exact = march_transient(marched(all), force, request);
  ASSERT_TRUE(exact.complete);
  EXPECT_EQ(exact.q.cols(), 2);
  const auto error = [&](TransientMethod method, double delta) {
    request.method = method;
    request.delta = delta;
    return (march_transient(marched(all), force, request).x - exact.x).cwiseAbs().maxCoeff();
  };
  for (const TransientMethod method : {TransientMethod::algorithm_one, TransientMethod::algorithm_two}) {
    const double coarse = error(method, 1e-2), fine = error(method, 2.5e-3);
    EXPECT_GT(coarse / fine, 10.0);
    EXPECT_LT(fine, 1e-4);
  }
}

/// A spring that pulls away: numbers end, and it is said.
TEST(CubicMarch, AMotionThatRunsAwayIsIncomplete) {
  const MatrixAssembly all = oscillator(0.1, {.name = "spring", .cubic = -1.0});
  const ForceHistory force = ForceHistory::half_sine(VectorXd::Constant(1, 30.0), 1.0);
  for (const TransientMethod method : {TransientMethod::exact, TransientMethod::algorithm_two}) {
    const Transient told = march_transient(
        marched(all), force, {.duration = 20.0, .step = 0.1, .method = method, .delta = 1e-3, .responses = one(1.0)});
    EXPECT_FALSE(told.complete);
    EXPECT_TRUE(told.x.allFinite());
  }
}

}  // namespace
}  // namespace jointid::response
