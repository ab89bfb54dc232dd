#include "records/order/order_phasors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "base/random.hpp"

namespace jointid::records {
namespace {

using testing::HasSubstr;

constexpr double rate = 2560.0, pi = std::numbers::pi;

using Signal = std::function<double(double)>;

Channel channel(const std::string& name, ChannelKind kind, double seconds, const Signal& signal, double noise,
                std::uint64_t seed) {
  Channel out = {.name = name, .dof = {.node = kind == ChannelKind::force ? 1 : 2}, .kind = kind};
  for (std::size_t i = 0; static_cast<double>(i) < seconds * rate; ++i) {
    const double random = normal_numbers({.seed = seed, .trial = 0, .set = kind == ChannelKind::force ? 0u : 1u}, i)[0];
    out.samples.push_back(signal(static_cast<double>(i) / rate) + noise * random);
  }
  return out;
}

Record record(double seconds, const Signal& force, const Signal& motion, double noise = 0.0, std::uint64_t seed = 1) {
  return {.file = "run.csv",
          .rate_hz = rate,
          .channels = {channel("F", ChannelKind::force, seconds, force, noise, seed),
                       channel("x", ChannelKind::displacement, seconds, motion, noise, seed)}};
}

constexpr double hz = 37.3137, shift = 0.7;

double sine_force(double t) { return 3.0 * std::cos(2.0 * pi * hz * t + 0.4) + 0.06 * std::cos(6.0 * pi * hz * t - 1.1); }
double sine_motion(double t) { return 2.0 * std::cos(2.0 * pi * hz * t + 0.4 + shift) + 0.3 * std::cos(6.0 * pi * hz * t); }

/// Ratios do not depend on where time begins: of harmonic n over the n-th power of the force's phase.
Complex turned(const OrderPhasors& phasors, Eigen::Index row, int n, Eigen::Index of) {
  const Complex first = phasors.value(0, 0) / std::abs(phasors.value(0, 0));
  return phasors.value(row, of) / std::pow(first, n);
}

TEST(OrderPhasors, OfASineAreItsOwn) {
  const OrderPhasors found = steady_phasors(record(4.0, sine_force, sine_motion), {.harmonics = {1, 3}});
  EXPECT_NEAR(found.frequency_hz, hz, 1e-8);
  EXPECT_NEAR(std::abs(found.value(0, 0)), 3.0, 1e-8);
  EXPECT_LT(std::abs(turned(found, 0, 1, 1) - std::polar(2.0, shift)), 1e-7);
  EXPECT_LT(std::abs(turned(found, 1, 3, 1) - std::polar(0.3, -1.2)), 1e-7);
  EXPECT_LT(std::abs(turned(found, 1, 3, 0) - std::polar(0.06, -1.1 - 1.2)), 1e-7);
}

/// Errors over deviations have rms 1, as 100 records say to 7 %.
TEST(OrderPhasors, DeviationsAreThoseOfNoise) {
  double sum = 0.0, force = 0.0;
  constexpr int records = 100;
  for (int seed = 1; seed <= records; ++seed) {
    const OrderPhasors found =
        steady_phasors(record(1.0, sine_force, sine_motion, 0.1, static_cast<std::uint64_t>(seed)), {.harmonics = {1, 3}});
    const double third = std::norm(found.value(1, 1)) - 0.09;  // of |X₃|², whose deviation is 2·0.3σ
    sum += std::pow(third / (0.6 * found.deviation(1, 1)), 2) / records;
    force += std::pow((std::abs(found.value(0, 0)) - 3.0) / found.deviation(0, 0), 2) / records;
  }
  EXPECT_NEAR(std::sqrt(sum), 1.0, 0.2);
  EXPECT_NEAR(std::sqrt(force), 1.0, 0.2);
}

/// A frequency that rises by 1 Hz/s, a motion whose amplitude and phase follow a resonance at 100 Hz without lag.
constexpr double start_hz = 80.0, rise = 1.0;

double sweep_phase(double t) { return 2.0 * pi * (start_hz * t + 0.5 * rise * t * t); }
Complex resonance(double at_hz) { return 1.0 / Complex(1.0 - std::pow(at_hz / 100.0, 2), 0.04); }
double sweep_force(double t) { return 2.0 * std::cos(sweep_phase(t)); }
double sweep_motion(double t) {
  return (resonance(start_hz + rise * t) * std::polar(1.0, sweep_phase(t))).real() + 0.1 * std::cos(3.0 * sweep_phase(t) + 0.5);
}

TEST(OrderPhasors, OfASweepAreThoseOfItsLines) {
  const std::vector<double> lines = {60.0, 90.0, 99.0, 100.0, 101.5, 110.0, 140.0};
  const auto found = sweep_phasors(record(40.0, sweep_force, sweep_motion), lines, {.harmonics = {1, 3}, .periods = 20});
  ASSERT_EQ(found.size(), 5u);  // those that it passes
  for (std::size_t i = 0; i < found.size(); ++i) {
    const OrderPhasors& one = found[i];
    EXPECT_NEAR(one.frequency_hz, lines[i + 1], 1e-9);
    EXPECT_NEAR(std::abs(one.value(0, 0)), 2.0, 1e-5);
    const Complex exact = resonance(one.frequency_hz);
    EXPECT_LT(std::abs(turned(one, 0, 1, 1) - exact), (2.0 * one.window_bias + 1e-5) * std::abs(exact)) << one.frequency_hz;
    EXPECT_LT(std::abs(turned(one, 1, 3, 1) - std::polar(0.1, 0.5)), 1e-4);
    EXPECT_LT(one.window_bias, 0.01);
  }
  // The lag of a linear resonance is H″α/2; at its top |H″| is 2/δ² of H with the half width δ = 2 Hz.
  EXPECT_NEAR(found[2].lag_bias, 0.5 * (2.0 * pi) * rise * 2.0 / std::pow(2.0 * pi * 2.0, 2), 0.15 * found[2].lag_bias);
}

/// The message of an InputError.
std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(OrderPhasors, SayWhatIsWrongWithARecord) {
  const auto steady = [](const Record& of, OrderOptions options = {}) { return error_of([&] { steady_phasors(of, options); }); };
  const auto clipped = [](double t) { return std::clamp(sine_motion(t), -1.5, 1.5); };
  const auto growing = [](double t) { return (1.0 + 0.05 * t) * sine_motion(t); };
  const auto two = [](double t) {
    return std::cos(2.0 * pi * 30.0 * t) + 2.0 * std::cos(2.0 * pi * 41.0 * t) + std::cos(2.0 * pi * 77.7 * t);
  };
  EXPECT_EQ(steady(record(4.0, sine_force, sine_motion)), "none");
  EXPECT_THAT(steady(record(0.2, sine_force, sine_motion)), HasSubstr("upward zero crossings"));
  EXPECT_THAT(steady(record(4.0, sine_force, sine_motion), {.settle_s = 3.9}), HasSubstr("settle"));
  EXPECT_THAT(steady(record(4.0, sine_force, clipped)), HasSubstr("clipped"));
  EXPECT_THAT(steady(record(4.0, sine_force, [](double) { return 0.2; })), HasSubstr("it measured nothing"));
  EXPECT_THAT(steady(record(4.0, sine_force, growing)), HasSubstr("no steady state"));
  EXPECT_THAT(steady(record(4.0, two, sine_motion)), HasSubstr("no steady sine"));
  EXPECT_THAT(steady(record(4.0, sine_force, sine_motion), {.frequency_hz = 38.0}), HasSubstr("not 38 Hz"));
  EXPECT_THAT(steady(record(4.0, sine_force, sine_motion), {.harmonics = {1, 31}}), HasSubstr("order 32"));
  Record hole = record(4.0, sine_force, sine_motion);
  hole.channels[1].samples[7] = std::nan("");
  EXPECT_THAT(steady(hole), HasSubstr("sample 8 is missing"));
  EXPECT_THAT(error_of([&] { sweep_phasors(record(4.0, sine_force, sine_motion), {37.0}, {}); }), HasSubstr("does not sweep"));
  const auto there_and_back = [](double t) { return sweep_force(t < 10.0 ? t : 20.0 - t); };
  EXPECT_THAT(error_of([&] { sweep_phasors(record(20.0, there_and_back, sweep_motion), {85.0}, {}); }),
              HasSubstr("more than once"));
}

/// Six bits and a sine of a few steps: flat tops of a coarse channel are not taken for clipping.
TEST(OrderPhasors, ACoarseChannelIsNotClipped) {
  const auto coarse = [](double t) { return std::round(10.0 * sine_motion(t)) / 10.0; };
  EXPECT_EQ(error_of([&] { steady_phasors(record(4.0, sine_force, coarse), {.harmonics = {1, 3}}); }), "none");
}

}  // namespace
}  // namespace jointid::records
