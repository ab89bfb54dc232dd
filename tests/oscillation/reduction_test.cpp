#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/control.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/reduction/reduction_error.hpp"
#include "tests/oscillation/golden_systems.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Coordinates at `count` equal times of [0, end), a row a time.
oscillation::Samples period_samples(const ContactSystem& system, const PeriodicOrbit& orbit, std::size_t count) {
  StickSlip motion(system, orbit.state, Mode::stick);
  motion.break_away();
  const std::vector<double> times = equal_times(orbit.period / static_cast<double>(count), count);
  oscillation::Samples out(at(count), system.degrees());
  std::size_t next = 0;
  motion.on_piece = [&](const Piece& piece) {
    for (; next < count && times[next] <= piece.start + piece.length; ++next)
      out.row(at(next)) = piece.at(times[next] - piece.start).head(system.degrees()).transpose();
  };
  motion.advance(orbit.period);
  return out;
}

TEST(Reduced, MeetsTheGoldenModels) {
  OSCILLATION_CASE(golden, "chain_reduced");
  const json& orbit_case = golden_all.at("chain_orbit");
  const auto& input = golden["input"];
  const BeltChain chain = chain_of(input);
  const Model full{mechanics(chain), {chain.velocity, 0.0, 0.0}, chain.friction};
  const ContactSystem system = contact_system(full);
  const VectorXd near = system.state(vector_of(orbit_case["expected"]["x"]), vector_of(orbit_case["expected"]["v"]));
  const PeriodicOrbit orbit = break_away_orbit(system, near, 8);
  ASSERT_TRUE(orbit.converged);
  const oscillation::Pod modes = oscillation::pod(period_samples(system, orbit, 256));
  const ComparedMotion motion{vector_of(input["x0"]), vector_of(input["v0"]), 0.0, input["t_end"], 600, {}};
  const Trajectory truth = trajectory(full, motion);
  for (const auto& [count, expected] : golden["expected"].items()) {
    const ReductionBasis basis = proper_modes(modes, std::stol(count));
    const ContactSystem small = contact_system(reduced(full, basis));
    const VectorXd start =
        small.state(reduced_displacements(full.mechanics, basis, motion.q), reduced_velocities(full.mechanics, basis, motion.v));
    const Motion found = integrate(small, start, motion.length);
    const auto times = expected["event_times"].get<std::vector<double>>();
    ASSERT_GE(found.events.size(), times.size());
    for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(found.events[k].time, times[k], 1e-6) << count;
    const VectorXd end = basis.mean + basis.columns * found.end.head(basis.columns.cols());
    EXPECT_LT((end - vector_of(expected["x_end"])).cwiseAbs().maxCoeff(), 1e-6);
    const ReductionError error = reduction_error(full, truth, trajectory(full, basis, motion), {});
    EXPECT_NEAR(100.0 * error.motion, expected["deviation_X_percent"], 1e-4) << count;
    EXPECT_NEAR(100.0 * error.energy, expected["deviation_E_percent"], 1e-4) << count;
  }
}

/// The beam on its slider: N varies with the motion, so that a basis with a mean shows whether N follows.
Model beam_model(bool rigid) {
  Cantilever beam;
  beam.damping = one_per_cent(beam);
  if (rigid) beam.friction.contact_stiffness.reset();
  return {mechanics(beam), {0.0, beam.amplitude, 2.0 * M_PI * beam.frequency_hz}, beam.friction};
}

TEST(Reduced, OnAsManyCoordinatesAsThereAreIsTheModelItself) {
  for (const bool rigid : {false, true}) {
    const Model full = beam_model(rigid);
    const Index n = full.mechanics.contact.size();
    const ComparedMotion motion{VectorXd::Zero(n), VectorXd::Zero(n), 0.0, 0.3, 300, MatrixXd::Ones(1, n)};
    const Trajectory truth = trajectory(full, motion);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    ReductionBasis any{MatrixXd(n, n), VectorXd(n)};
    for (double& x : any.columns.reshaped()) x = normal(random);
    for (double& x : any.mean) x = 0.003 * normal(random);
    for (const ReductionBasis& basis : {normal_modes(full.mechanics, n), craig_bampton(full.mechanics, n), any}) {
      const ReductionError error = reduction_error(full, truth, trajectory(full, basis, motion), motion.observed);
      EXPECT_EQ(error.status, MotionEnd::ok);
      EXPECT_LT(error.motion, 1e-7) << rigid;
      EXPECT_LT(error.energy, 1e-7);
      EXPECT_LT(error.observed(0), 1e-8);
    }
  }
}

TEST(Reduced, CraigBamptonHoldsTheStaticShapeAndTheStickingModes) {
  const Model full = beam_model(true);
  const Mechanics& m = full.mechanics;
  const ReductionBasis basis = craig_bampton(m, 3);
  EXPECT_LT((basis.columns.transpose() * m.mass * basis.columns - MatrixXd::Identity(3, 3)).cwiseAbs().maxCoeff(), 1e-12);
  // A static force at the contact is exact, whatever is left out.
  const Mechanics small = reduced(m, basis);
  const auto static_at_contact = [](const Mechanics& of) {
    return of.contact.dot(dense::solve_positive(of.stiffness, MatrixXd(of.contact)).col(0));
  };
  EXPECT_NEAR(static_at_contact(small), static_at_contact(m), 1e-10 * static_at_contact(m));
  EXPECT_LT(static_at_contact(reduced(m, normal_modes(m, 3))), 0.9999 * static_at_contact(m));
  // The other two do not move the contact.
  EXPECT_LT((m.contact.transpose() * basis.columns.rightCols(2)).cwiseAbs().maxCoeff(), 1e-9 * m.contact.norm());
}

TEST(Reduced, NormalModesDiagonaliseAndOrdersAreChecked) {
  Cantilever beam;
  const Mechanics m = mechanics(beam);
  const ReductionBasis basis = normal_modes(m, 4);
  const MatrixXd stiffness = reduced(m, basis).stiffness;
  const VectorXd hz = natural_frequencies(beam).head(4);
  for (Index k = 0; k < 4; ++k) EXPECT_NEAR(std::sqrt(stiffness(k, k)) / (2.0 * M_PI), hz(k), 1e-9 * hz(k));
  for (const Index wrong : {Index{0}, Index{7}}) {
    EXPECT_THROW(normal_modes(m, wrong), InputError);
    EXPECT_THROW(craig_bampton(m, wrong), InputError);
  }
  Mechanics loose = m;
  loose.stiffness.setZero();
  EXPECT_THROW(craig_bampton(loose, 2), InputError);
  EXPECT_THROW(trajectory(beam_model(true), ComparedMotion{VectorXd::Zero(6), VectorXd::Zero(6), 0.0, 0.0, 10, {}}), InputError);
}

TEST(Reduced, StopsWhenAsked) {
  const Model full = beam_model(true);
  ComparedMotion motion{VectorXd::Zero(6), VectorXd::Zero(6), 0.0, 1.0, 10, {}};
  motion.interrupted = [] { return true; };
  EXPECT_THROW(trajectory(full, motion), Interrupted);
}

}  // namespace
}  // namespace jointid::oscillation
