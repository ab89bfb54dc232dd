#include "oscillation/orbit/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "oscillation/delay/divergence.hpp"
#include "oscillation/delay/mutual_information.hpp"
#include "oscillation/delay/recurrence.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/system/thesis_systems.hpp"

namespace jointid::oscillation {
namespace {

SweepCase chain_at(double velocity) {
  BeltChain chain;
  chain.masses = 3;
  chain.damping = 0.05;
  chain.velocity = velocity;
  SweepCase out{contact_system(chain), {}, {}, 500.0, 300.0, 0.0};
  out.start = out.system.state(Eigen::Vector3d(0.9, 1.8, 2.7), Eigen::Vector3d::Zero());
  out.form = Eigen::VectorXd::Unit(out.system.size(), 0);
  return out;
}

TEST(Sweep, IsTheSameForAnyThreads) {
  const std::vector<double> velocities = {0.1, 0.15, 0.2, 0.25, 0.3};
  const auto one = sweep(velocities, chain_at, {1});
  const auto four = sweep(velocities, chain_at, {4});
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    EXPECT_EQ(one[k].parameter, velocities[k]);
    EXPECT_EQ(one[k].values, four[k].values);
    EXPECT_EQ(one[k].status, MotionEnd::ok);
  }
  ASSERT_GE(one[2].values.size(), 10u);  // a stable orbit of one slip at V = 0.2
  for (const double value : one[2].values) EXPECT_NEAR(value, 1.6393580543696329, 1e-6);
  const auto endless = [](double velocity) {
    SweepCase each = chain_at(velocity);
    each.length = 0.0;
    return each;
  };
  EXPECT_THROW(sweep(velocities, endless), InputError);
  const auto broken = [](double) -> SweepCase { throw InputError({ErrorKind::usage, "", "case", "is wrong", ""}); };
  EXPECT_THROW(sweep(velocities, broken, {2}), InputError);
  std::size_t told = 0;
  SweepOptions asked{2};
  asked.done = [&](const SweepPoint& point) { told += point.values.size(); };
  sweep(velocities, chain_at, asked);
  std::size_t all = 0;
  for (const SweepPoint& point : one) all += point.values.size();
  EXPECT_EQ(told, all);
  asked.interrupted = [] { return true; };
  EXPECT_THROW(sweep(velocities, chain_at, asked), Interrupted);
}

TEST(Sweep, TakesADrivenSystemOnceACycle) {
  const auto beam_at = [](double hz) {
    Cantilever beam;
    beam.frequency_hz = hz;
    beam.damping = one_per_cent(beam);
    SweepCase out{contact_system(beam), {}, {}, 600.0 / hz, 9.0 / hz, 1.0 / hz};
    out.start = out.system.state(Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6));
    out.form = Eigen::VectorXd::Zero(out.system.size());
    out.form.head(6) = strain_row(beam, 0.05).transpose();
    return out;
  };
  const auto found = sweep({12.0}, beam_at);
  ASSERT_EQ(found[0].values.size(), 9u);
  for (std::size_t k = 3; k < 9; ++k) EXPECT_NEAR(found[0].values[k], found[0].values[k - 3], 1e-10);  // period 3 (theory, 6)
  EXPECT_GT(std::abs(found[0].values[1] - found[0].values[0]), 1e-6);
}

/// The chaotic chain's record: λ₁ = 0.0156 is known from the model, but the record alone has no plateau (theory, 4).
TEST(ChainRecord, LeavesTheExponentUndetermined) {
  BeltChain chain;
  const ContactSystem system = contact_system(chain);
  const Eigen::VectorXd start = system.state(0.9 * Eigen::VectorXd::LinSpaced(10, 1.0, 10.0), Eigen::VectorXd::Zero(10));
  const double step = 0.2;
  const Motion motion = integrate(system, start, 2600.0, equal_times(step, 13000));
  std::vector<double> velocity;
  for (Eigen::Index i = 2500; i < 10500; ++i) velocity.push_back(motion.samples(10, i));
  const auto curve = oscillation::information_curve(velocity, 30, {16, false});
  ASSERT_TRUE(curve.first_minimum);
  EXPECT_NEAR(step * static_cast<double>(*curve.first_minimum), 1.2, 0.21);
  const auto found = oscillation::largest_exponent_rosenstein(velocity, {{6, *curve.first_minimum}, 60, 150, step});
  EXPECT_FALSE(found.nats_per_second) << *found.nats_per_second;
}

/// A record of the chaotic chain of three masses leads to an unstable orbit: recurrence, then Newton.
TEST(ChainRecord, LeadsToAnUnstableOrbit) {
  BeltChain chain;
  chain.masses = 3;
  chain.damping = 0.005;
  chain.friction.decay = 1.0;
  const ContactSystem system = contact_system(chain);
  StickSlip motion(system, system.state(Eigen::Vector3d(0.9, 1.8, 2.7), Eigen::Vector3d::Zero()));
  motion.advance(1500.0);
  std::vector<Event> events;
  motion.on_event = [&](const Event& event) {
    if (event.from == Mode::stick) events.push_back(event);
  };
  motion.advance(4500.0);
  RowMatrixXd points(static_cast<Eigen::Index>(events.size()), 6);
  for (std::size_t k = 0; k < events.size(); ++k) points.row(static_cast<Eigen::Index>(k)) = events[k].state.head(6).transpose();
  auto returns = oscillation::recurrences(points, 0.5 * oscillation::half_mean_step(points));
  std::ranges::sort(returns, {}, &oscillation::Recurrence::distance);
  std::size_t unstable = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(returns.size(), 60); ++k) {
    if (returns[k].period > 6) continue;
    const PeriodicOrbit orbit = break_away_orbit(system, events[returns[k].start].state, returns[k].period);
    if (orbit.converged && orbit.residual < 1e-11 && std::abs(orbit.multipliers[0]) > 1.001) ++unstable;
  }
  EXPECT_GT(unstable, 0u);
}

}  // namespace
}  // namespace jointid::oscillation
