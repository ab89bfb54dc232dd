#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/pod/pod.hpp"
#include "tests/oscillation/golden_systems.hpp"

namespace jointid::oscillation {
namespace {

constexpr int per_cycle = 96;

/// What the golden cases say of a stretch of whole cycles from a start at phase 0.
struct BeamRecord {
  std::vector<Event> events;      ///< times from the start of the stretch
  std::vector<double> quarter;    ///< strain at x = 0.05 with the slider at −A
  oscillation::Samples displacements;  ///< at x = 0.05 … 0.30
  double nub_largest = -1.0, nub_smallest = 1.0;
};

BeamRecord record(const Cantilever& beam, StickSlip& motion, std::size_t cycles) {
  const double cycle = 1.0 / beam.frequency_hz, begin = motion.time();
  const Eigen::Index n = at(beam.modes);
  const Eigen::VectorXd p = mechanics(beam).contact;
  const Eigen::RowVectorXd strain = strain_row(beam, 0.05);
  Eigen::MatrixXd points(6, n);
  for (Eigen::Index i = 0; i < 6; ++i) points.row(i) = displacement_row(beam, 0.05 * static_cast<double>(i + 1));
  BeamRecord out;
  const auto count = static_cast<Eigen::Index>(cycles) * per_cycle;
  out.displacements.resize(count, 6);
  Eigen::Index next = 0;
  motion.on_event = [&](Event event) {
    event.time -= begin;
    out.events.push_back(event);
  };
  motion.on_piece = [&](const Piece& piece) {
    for (; next < count; ++next) {
      const double time = begin + cycle * static_cast<double>(next) / per_cycle;
      if (time > piece.start + piece.length) break;
      const Eigen::VectorXd q = piece.at(time - piece.start).head(n);
      out.displacements.row(next) = (points * q).transpose();
      out.nub_largest = std::max(out.nub_largest, p.dot(q)), out.nub_smallest = std::min(out.nub_smallest, p.dot(q));
      if (next % per_cycle == per_cycle * 3 / 4) out.quarter.push_back(strain.dot(q));
    }
  };
  motion.advance(begin + cycle * static_cast<double>(cycles));
  motion.on_event = nullptr;
  motion.on_piece = nullptr;
  return out;
}

TEST(Beam, SteadyMotionMeetsTheGoldenValues) {
  for (const char* name : {"beam_steady_12", "beam_steady_41"}) {
    OSCILLATION_CASE(golden, name);
    const auto& expected = golden["expected"];
    const Cantilever beam = beam_of(golden["input"]);
    const ContactSystem system = contact_system(beam);
    const std::size_t cycles = expected["period_in_cycles"];
    const double cycle = 1.0 / beam.frequency_hz;
    StickSlip transient(system, at_rest(system));
    ASSERT_EQ(transient.advance(600.0 * cycle), MotionEnd::ok);
    const PeriodicOrbit orbit = driven_orbit(system, transient.state(), transient.mode(), cycle, cycles);
    ASSERT_TRUE(orbit.converged) << orbit.residual;
    EXPECT_LT(orbit.residual, 1e-12);
    EXPECT_LT(std::abs(orbit.multipliers[0]), 1.0);
    bool met = false;
    const auto quarter = expected["quarter_phase_strain"].get<std::vector<double>>();
    Eigen::VectorXd z = orbit.state;
    Mode mode = orbit.mode;
    for (std::size_t shift = 0; shift < cycles && !met; ++shift) {  // which cycle comes first is open
      StickSlip motion(system, z, mode);
      const BeamRecord found = record(beam, motion, cycles);
      StickSlip one(system, z, mode);
      one.advance(cycle);
      const Eigen::Index n = system.degrees();
      const double spring = one.state()(2 * n + 3);
      z = system.state(one.state().head(n), one.state().segment(n, n));
      z(2 * n + 3) = spring;
      mode = one.mode();
      double worst = 0.0;
      for (std::size_t k = 0; k < quarter.size(); ++k) worst = std::max(worst, std::abs(found.quarter[k] - quarter[k]));
      if (worst > 1e-8) continue;
      met = true;
      EXPECT_NEAR(found.nub_largest, expected["nub_max"], 1e-8);
      EXPECT_NEAR(found.nub_smallest, expected["nub_min"], 1e-8);
      const auto times = expected["event_times_mod_period"].get<std::vector<double>>();
      ASSERT_EQ(found.events.size(), times.size());
      for (std::size_t k = 0; k < times.size(); ++k) {
        EXPECT_NEAR(found.events[k].time, times[k], 1e-6);
        EXPECT_EQ(static_cast<int>(found.events[k].from), expected["from_to"][k][0]);
        EXPECT_EQ(static_cast<int>(found.events[k].to), expected["from_to"][k][1]);
      }
      const auto fractions = expected["pod_fractions"].get<std::vector<double>>();
      const Eigen::VectorXd ours = oscillation::pod(found.displacements).square_fractions();
      for (std::size_t k = 0; k < fractions.size(); ++k) EXPECT_NEAR(ours(at(k)), fractions[k], 1e-5);
    }
    EXPECT_TRUE(met) << name;
  }
}

TEST(Beam, ChaosMeetsTheGoldenInvariants) {
  OSCILLATION_CASE(golden, "beam_chaos_10");
  const auto& expected = golden["expected"];
  const Cantilever beam = beam_of(golden["input"]);
  const ContactSystem system = contact_system(beam);
  const double cycle = 1.0 / beam.frequency_hz;
  const std::size_t cycles = 400;  // of the 1000 of the golden case
  const Exponents found = lyapunov_exponents(system, at_rest(system), {2, 100.0 * cycle, 400.0 * cycle, cycle});
  EXPECT_EQ(found.status, MotionEnd::ok);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(
        agree(found.exponent[k], found.standard_error[k], expected["lyapunov_per_s"][k], expected["lyapunov_std_error"][k], 0.0))
        << found.exponent[k] << " ± " << found.standard_error[k];
  }
  StickSlip motion(system, at_rest(system));
  motion.advance(100.0 * cycle);
  const BeamRecord stretch = record(beam, motion, cycles);
  double mean = 0.0, square = 0.0;
  for (const double e : stretch.quarter) mean += e / static_cast<double>(cycles);
  for (const double e : stretch.quarter) square += (e - mean) * (e - mean) / static_cast<double>(cycles);
  EXPECT_NEAR(mean, expected["quarter_phase_strain_mean"], 5e-6);
  EXPECT_NEAR(std::sqrt(square), expected["quarter_phase_strain_std"], 3e-6);
  EXPECT_NEAR(static_cast<double>(stretch.events.size()) / static_cast<double>(cycles), expected["events_per_cycle"], 0.1);
  const auto fractions = expected["pod_fractions"].get<std::vector<double>>();
  const Eigen::VectorXd ours = oscillation::pod(stretch.displacements).square_fractions();
  for (std::size_t k = 0; k < fractions.size(); ++k) EXPECT_NEAR(ours(at(k)), fractions[k], 5e-4);
}

}  // namespace
}  // namespace jointid::oscillation
