#include "oscillation/integrate/stick_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "oscillation/integrate/first_root.hpp"
#include "oscillation/measurement/beam_shapes.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "tests/oscillation/golden_systems.hpp"

namespace jointid::oscillation {
namespace {

TEST(OneMass, OnABeltMeetsItsClosedForm) {
  OSCILLATION_CASE(golden, "sdof_coulomb");
  const auto& expected = golden["expected"];
  const ContactSystem system = contact_system(chain_of(golden["input"]));
  StickSlip motion(system, system.state(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, golden["input"]["V"])));
  std::vector<Event> events;
  double largest = 0.0, smallest = 1.0;
  motion.on_event = [&](const Event& event) { events.push_back(event); };
  motion.on_piece = [&](const Piece& piece) {
    const Eigen::VectorXd c = piece.along(Eigen::VectorXd::Unit(system.size(), 1)), down = c(0) > 0.0 ? c : Eigen::VectorXd(-c);
    const auto turn = first_root({down.data(), static_cast<std::size_t>(down.size())}, piece.length);
    if (!turn) return;
    const double x = piece.at(*turn)(0);
    largest = std::max(largest, x), smallest = std::min(smallest, x);
  };
  ASSERT_EQ(motion.advance(60.0), MotionEnd::ok);
  ASSERT_GT(events.size(), 6u);
  std::size_t k = events[2].to == Mode::forward ? 2 : 3;
  ASSERT_EQ(events[k].to, Mode::forward);
  const double tolerance = 1e-14;
  EXPECT_NEAR(events[k + 1].time - events[k].time, expected["slip_time"], tolerance);
  EXPECT_NEAR(events[k + 2].time - events[k + 1].time, expected["stick_time"], tolerance);
  EXPECT_NEAR(events[k + 2].time - events[k].time, expected["period"], tolerance);
  EXPECT_NEAR(events[k].state(0), expected["x_slip_start"], 1e-14);
  EXPECT_NEAR(events[k + 1].state(0), expected["x_slip_end"], 1e-14);
  EXPECT_NEAR(largest, expected["x_max"], 1e-14);
  EXPECT_NEAR(smallest, expected["x_min"], 1e-14);
}

/// Steps are counted, over all calls; and where rounding hides them, time does not stand for ever.
TEST(StickSlip, ComesToAnEnd) {
  const ContactSystem system = contact_system(BeltChain{});
  const Eigen::VectorXd start = system.state(Eigen::VectorXd::Zero(10), Eigen::VectorXd::Zero(10));
  StickSlip counted(system, start);
  counted.most_steps = 200;
  EXPECT_EQ(counted.advance(1e9), MotionEnd::too_long);
  EXPECT_GT(counted.time(), 1.0);
  EXPECT_EQ(counted.advance(2e9), MotionEnd::too_long);
  StickSlip enough(system, start);
  EXPECT_EQ(enough.advance(counted.time()), MotionEnd::ok);
  StickSlip late(system, start, std::nullopt, 1e18);
  EXPECT_EQ(late.advance(1e18 + 1e6), MotionEnd::stalled);
  EXPECT_STREQ(word(MotionEnd::too_long), "too_long");
}

TEST(OneMass, WithAFallingLawMeetsTheGoldenEvents) {
  OSCILLATION_CASE(golden, "sdof_stribeck");
  const ContactSystem system = contact_system(chain_of(golden["input"]));
  const Motion motion = integrate(system, start_of(system, golden["input"]), golden["input"]["t_end"]);
  const auto& events = golden["expected"]["events"];
  ASSERT_GE(motion.events.size(), events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_NEAR(motion.events[k].time, events[k]["t"], 1e-9);
    EXPECT_EQ(static_cast<int>(motion.events[k].from), events[k]["from"]);
    EXPECT_EQ(static_cast<int>(motion.events[k].to), events[k]["to"]);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(motion.events[k].state(i), events[k]["state"][static_cast<std::size_t>(i)], 1e-9);
  }
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(motion.end(i), golden["expected"]["state_end"][static_cast<std::size_t>(i)], 1e-9);
  EXPECT_NEAR(motion.events[7].time - motion.events[5].time, golden["expected"]["period_limit_cycle"], 1e-9);
}

TEST(OneMass, RingsDownToItsStop) {
  OSCILLATION_CASE(golden, "ringdown");
  const auto& input = golden["input"];
  BeltChain chain{1,   input["m"], input["k"],
                  0.0, 0.0,        {input["friction_force"], input["friction_force"], std::nullopt, 1.0, 0.0, std::nullopt}};
  const ContactSystem system = contact_system(chain);
  const Motion motion = integrate(
      system, system.state(Eigen::VectorXd::Constant(1, input["x0"]), Eigen::VectorXd::Constant(1, input["v0"])), 100.0);
  const auto points = golden["expected"]["turning_points"].get<std::vector<double>>();
  ASSERT_EQ(motion.status, MotionEnd::ok);
  ASSERT_EQ(motion.events.back().to, Mode::stick);
  EXPECT_NEAR(motion.events.back().time, golden["expected"]["stop_time"], 1e-11);
  EXPECT_NEAR(motion.end(0), golden["expected"]["stop_position"], 1e-11);
  ASSERT_GE(motion.events.size() + 1, points.size() - 1);
  for (std::size_t k = 0; k < motion.events.size() && k + 1 < points.size(); ++k)
    EXPECT_NEAR(motion.events[k].state(0), points[k + 1], 1e-11);
}

TEST(OneMass, ForcedWithoutStopsMeetsDenHartog) {
  OSCILLATION_CASE(golden, "den_hartog");
  const auto& input = golden["input"];
  const double k = input["k"], m = input["m"], w = input["frequency_ratio"].get<double>() * std::sqrt(k / m);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  const Mechanics mechanics{m * one, 0.0 * one, k * one, one, {}, input["force_amplitude"].get<double>() * one};
  const ContactSystem system(mechanics, {0.0, 0.0, w},
                             {input["friction_force"], input["friction_force"], std::nullopt, 1.0, 0.0, std::nullopt});
  const double cycle = 2.0 * std::numbers::pi / w;
  StickSlip motion(system, system.state(Eigen::VectorXd::Constant(1, 1.4), Eigen::VectorXd::Constant(1, -0.3)));
  motion.advance(300.0 * cycle);
  const PeriodicOrbit orbit = driven_orbit(system, motion.state(), motion.mode(), cycle, 1);
  ASSERT_TRUE(orbit.converged);
  StickSlip round(system, orbit.state, orbit.mode);
  double amplitude = 0.0;
  round.on_event = [&](const Event& event) { amplitude = std::max(amplitude, std::abs(event.state(0))); };
  round.advance(cycle);
  EXPECT_NEAR(amplitude, golden["expected"]["amplitude"], 1e-11);
}

TEST(OneMass, OnAnElasticSliderMeetsTheGoldenSteadyState) {
  OSCILLATION_CASE(golden, "jenkins_forced");
  const auto& input = golden["input"];
  const auto& expected = golden["expected"];
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  const double w = input["omega"];
  const Mechanics mechanics{input["m"].get<double>() * one,
                            input["c"].get<double>() * one,
                            input["k"].get<double>() * one,
                            one,
                            {},
                            input["force_amplitude"].get<double>() * one};
  const Friction slider{1.0, 1.0, std::nullopt, input["slip_force"], 0.0, input["kt"].get<double>()};
  const ContactSystem system(mechanics, {0.0, 0.0, w}, slider);
  const double cycle = 2.0 * std::numbers::pi / w;
  StickSlip transient(system, at_rest(system), Mode::stick);
  ASSERT_EQ(transient.advance(300.0 * cycle), MotionEnd::ok);
  const PeriodicOrbit orbit = driven_orbit(system, transient.state(), transient.mode(), cycle, 1);
  ASSERT_TRUE(orbit.converged);
  EXPECT_LT(orbit.residual, 1e-12);
  // 30 digits of the half-period's closed form; the golden values lie 9e-10 s beside it.
  EXPECT_NEAR(orbit.state(0), -1.91873454747105068, 1e-12);
  EXPECT_NEAR(orbit.state(1), 1.66342794621620305, 1e-12);
  EXPECT_NEAR(orbit.state(0), expected["x_at_t0"], 2e-9);
  EXPECT_NEAR(orbit.state(1), expected["v_at_t0"], 2e-9);
  EXPECT_NEAR(system.force(orbit.mode, orbit.state), expected["friction_force_at_t0"], 1e-9);
  std::vector<double> turns;
  double largest = 0.0;
  StickSlip motion(system, orbit.state, orbit.mode);
  motion.on_event = [&](const Event& event) {
    if (event.to == Mode::stick) turns.push_back(event.time), largest = std::max(largest, event.state(0));
  };
  ASSERT_EQ(motion.advance(cycle), MotionEnd::ok);
  ASSERT_EQ(turns.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(turns[k], expected["turning_times"][k], 1e-9);
  EXPECT_NEAR(turns[0], 2.54318939402093223, 1e-12);
  EXPECT_NEAR(largest, expected["x_max"], 1e-9);
}

TEST(Chains, MeetTheGoldenEvents) {
  for (const char* name : {"chain_short", "chain3_short"}) {
    OSCILLATION_CASE(golden, name);
    const ContactSystem system = contact_system(chain_of(golden["input"]));
    const Motion motion = integrate(system, start_of(system, golden["input"]), golden["input"]["t_end"]);
    const auto& events = golden["expected"]["events"];
    ASSERT_EQ(motion.events.size(), events.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_NEAR(motion.events[k].time, events[k]["t"], 1e-7);
      EXPECT_EQ(static_cast<int>(motion.events[k].from), events[k]["from"]);
      EXPECT_EQ(static_cast<int>(motion.events[k].to), events[k]["to"]);
      EXPECT_NEAR(motion.events[k].state(system.degrees() - 1), events[k]["x_last"], 1e-7);
    }
    const Eigen::Index n = system.degrees();
    EXPECT_LT((motion.end.head(n) - vector_of(golden["expected"]["x_end"])).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((motion.end.segment(n, n) - vector_of(golden["expected"]["v_end"])).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(Beam, MeetsTheGoldenEventsOfBothContacts) {
  for (const char* name : {"beam_events", "beam_events_rigid"}) {
    OSCILLATION_CASE(golden, name);
    const ContactSystem system = contact_system(beam_of(golden["input"]));
    const auto& events = golden["expected"]["events"];
    const Motion motion = integrate(system, at_rest(system), events.back()["t"].get<double>() + 1e-6);
    ASSERT_EQ(motion.events.size(), events.size());
    const Eigen::VectorXd p = mechanics(beam_of(golden["input"])).contact;
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_NEAR(motion.events[k].time, events[k]["t"], 1e-8) << name << k;
      EXPECT_EQ(static_cast<int>(motion.events[k].from), events[k]["from"]);
      EXPECT_EQ(static_cast<int>(motion.events[k].to), events[k]["to"]);
      EXPECT_NEAR(p.dot(motion.events[k].state.head(system.degrees())), events[k]["nub"], 1e-8);
      EXPECT_NEAR(motion.events[k].force, events[k]["force"], 1e-8) << name << k;
    }
  }
}

TEST(Beam, MatricesAndFrequenciesMeetTheGoldenOnes) {
  OSCILLATION_CASE(golden, "beam_modes");
  const auto& expected = golden["expected"];
  const Cantilever beam = beam_of(golden["input"]);
  const Mechanics found = mechanics(beam);
  const Eigen::Index n = found.contact.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    EXPECT_LT((found.mass.row(i).transpose() - vector_of(expected["M"][row])).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((found.stiffness.row(i).transpose() - vector_of(expected["K"][row])).cwiseAbs().maxCoeff(), 1e-9);
  }
  EXPECT_LT((found.contact - vector_of(expected["P"])).cwiseAbs().maxCoeff(), 1e-9);
  const std::vector<double> roots = oscillation::clamped_free_roots(beam.modes);
  EXPECT_LT((vector_of(roots) - vector_of(expected["roots_clamped_free"])).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((natural_frequencies(beam) - vector_of(expected["ritz_frequency_hz"])).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((tip_mass_frequencies(beam) - vector_of(expected["exact_tip_mass_frequency_hz"])).cwiseAbs().maxCoeff(), 1e-9);
  Cantilever bare = beam;
  bare.fixture_mass = bare.extension_density = 0.0;
  EXPECT_LT((natural_frequencies(bare) - vector_of(expected["bare_frequency_hz"])).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(beam.tip_mass(), expected["tip_mass"], 1e-15);
  EXPECT_NEAR(beam.bending_stiffness(), expected["EI"], 1e-15);
  EXPECT_NEAR(beam.mass_per_length(), expected["mass_per_length"], 1e-15);
}

/// Tangents through several events against central differences, all kinds of contact.
TEST(Tangents, ThroughEventsAreThoseOfDifferences) {
  BeltChain coulomb{3, 1.0, 1.0, 0.02, 0.25, {0.3, 0.5, std::nullopt, 3.0, 0.0, std::nullopt}}, falling = coulomb;
  falling.friction.decay = 2.0;
  Cantilever rigid, compliant;
  rigid.modes = compliant.modes = 3;
  rigid.damping = compliant.damping = 1.5e-3;
  rigid.friction.contact_stiffness.reset();
  struct Case {
    ContactSystem system;
    double until, step, size;
  };
  const Case cases[] = {{contact_system(coulomb), 35.0, 1e-5, 1.0},
                        {contact_system(falling), 35.0, 1e-5, 1.0},
                        {contact_system(rigid), 0.18, 1e-7, 1e-3},
                        {contact_system(compliant), 0.18, 1e-7, 1e-3}};
  for (const Case& each : cases) {
    const ContactSystem& system = each.system;
    const Eigen::Index motion = 2 * system.degrees();
    const Eigen::VectorXd start =
        system.state(each.size * Eigen::VectorXd::LinSpaced(system.degrees(), 0.5, 1.5), Eigen::VectorXd::Zero(system.degrees()));
    StickSlip orbit(system, start);
    orbit.tangents() = Eigen::MatrixXd::Identity(system.size(), motion);
    std::size_t events = 0;
    orbit.on_event = [&](const Event&) { ++events; };
    ASSERT_EQ(orbit.advance(each.until), MotionEnd::ok);
    EXPECT_GE(events, 3u);
    for (Eigen::Index k = 0; k < motion; ++k) {
      Eigen::VectorXd up = start, down = start;
      up(k) += each.step, down(k) -= each.step;
      const Eigen::VectorXd slope =
          (integrate(system, up, each.until).end - integrate(system, down, each.until).end) / (2.0 * each.step);
      const double scale = orbit.tangents().col(k).cwiseAbs().maxCoeff();
      EXPECT_LT((slope - orbit.tangents().col(k)).cwiseAbs().maxCoeff(), 1e-6 * scale) << k << " of " << motion;
    }
  }
}

TEST(Systems, WhatMakesNoSenseIsSaid) {
  BeltChain chain;
  chain.friction.statical = 0.1;
  EXPECT_THROW(contact_system(chain), InputError);
  Cantilever beam;
  beam.friction.decay = 2.0;
  EXPECT_THROW(contact_system(beam), InputError);
  chain.masses = 0;
  EXPECT_THROW(contact_system(chain), InputError);
  const ContactSystem system = contact_system(BeltChain{});
  EXPECT_THROW(system.state(Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)), InputError);
}

}  // namespace
}  // namespace jointid::oscillation
