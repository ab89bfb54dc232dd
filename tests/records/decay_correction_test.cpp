#include "records/estimate/decay_correction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace jointid::records {
namespace {

constexpr double sampled_hz = 1024.0;
constexpr std::size_t block_samples = 2048;

struct Mode {
  double hz, damping, size;
};
constexpr std::array<Mode, 3> modes = {{{40.0, 0.002, 1.0}, {97.3, 0.004, -0.6}, {101.0, 0.003, 0.8}}};

Complex pole(const Mode& mode) {
  const double w = 2.0 * std::numbers::pi * mode.hz;
  return {-mode.damping * w, w};
}

/// Σ over modes of the sampled impulse response size·e^(st) sin, by recursion, and its exact transform at iω.
std::vector<double> motion_of(const std::vector<double>& force) {
  std::vector<double> out(force.size());
  for (const Mode& mode : modes) {
    const Complex step = std::exp(pole(mode) / sampled_hz);
    Complex state = 0.0;
    for (std::size_t t = 0; t < force.size(); ++t) {
      state = step * state + force[t];
      out[t] += mode.size * state.imag();
    }
  }
  return out;
}

Complex exact(double hz) {
  const Complex z = std::polar(1.0, -2.0 * std::numbers::pi * hz / sampled_hz);
  Complex sum = 0.0;
  for (const Mode& mode : modes) {
    const Complex step = std::exp(pole(mode) / sampled_hz);
    sum += mode.size * (1.0 / (1.0 - step * z) - 1.0 / (1.0 - std::conj(step) * z)) / Complex{0.0, 2.0};
  }
  return sum;
}

Record blow(double noise, std::uint64_t trial) {
  std::vector<double> force(block_samples);
  for (std::size_t t = 0; t < 6; ++t) force[t + 4] = 100.0 * std::sin(std::numbers::pi * (static_cast<double>(t) + 1.0) / 7.0);
  std::vector<double> motion = motion_of(force);
  for (std::size_t t = 0; t < block_samples; ++t) motion[t] += noise * normal_numbers({7, trial}, t)[0];
  return {"a",
          sampled_hz,
          {{"F", frf::Dof::parse("1:+Z"), ChannelKind::force, force},
           {"x", frf::Dof::parse("2:+Z"), ChannelKind::displacement, motion}}};
}

/// A window that leaves e⁻⁹ at the end: without correction the peaks lie far below the true ones; with it the rest is what is cut
/// off.
TEST(DecayCorrection, GivesBackTheDampingOfTheStructure) {
  const Record record = blow(0.0, 0);
  FrfOptions options;
  options.decay_time_s = block_samples / sampled_hz / 9.0;
  options.highest_hz = 150.0;
  const MeasuredFrfs made = make_frfs({&record, 1}, options);
  for (std::size_t line = 40; line < made.set.header.lines(); ++line) {
    const Complex truth = exact(made.set.header.frequency_hz[line]);
    EXPECT_LE(std::abs(made.set.values[line] - truth), 0.02 * std::abs(truth) + 0.02) << made.set.header.frequency_hz[line];
  }
  options.decay_time_s.reset();
  const Complex cut = make_frfs({&record, 1}, options).set.values[80];
  EXPECT_GT(std::abs(cut - exact(40.0)), 0.2 * std::abs(exact(40.0)));  // what a blow of this length says without a window
}

/// A rational function of degree two is continued exactly, and its value is linear in its errors.
TEST(DecayCorrection, ContinuesAModeExactly) {
  Estimate made;
  const double spacing = 0.5, decay_time = 0.7;
  const Complex s0{-0.9, 60.0};
  const auto h = [&](Complex s) { return 3.0 / (s - s0) + 0.2; };
  for (int line = 0; line < 40; ++line) {
    made.frf.push_back(h(Complex{1.0 / decay_time, 2.0 * std::numbers::pi * spacing * line}));
    made.variance.push_back({1e-8, 2e-8});
    made.covariance.push_back(3e-8);
  }
  std::vector<Complex> apart(9);
  apart[0] = 1.0;
  correct_decay(made, 1, spacing, decay_time, apart);
  for (int line = 0; line < 40; ++line) {
    const auto at = static_cast<std::size_t>(line);
    const Complex truth = h(Complex{0.0, 2.0 * std::numbers::pi * spacing * line});
    EXPECT_LE(std::abs(made.frf[at] - truth), 1e-8 * std::abs(truth)) << line;
    EXPECT_NEAR(made.variance[at].real() + made.variance[at].imag(), made.covariance[at].real(),
                1e-9 * made.covariance[at].real());
    EXPECT_GT(made.variance[at].real(), 0.0);
  }
}

/// The stated variance is what 60 noisy tests of four blows are away from the clean one: on average over the lines, and on every
/// line to a factor of three.
TEST(DecayCorrection, StatesItsVariance) {
  FrfOptions options;
  options.decay_time_s = block_samples / sampled_hz / 9.0;
  options.highest_hz = 130.0;
  std::vector<double> scatter, stated;
  constexpr int trials = 60;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Record> records;
    for (int k = 0; k < 4; ++k) records.push_back(blow(2.0, static_cast<std::uint64_t>(4 * trial + k)));
    const MeasuredFrfs made = make_frfs(records, options);
    const MeasuredFrfs clean = make_frfs(std::vector(1, blow(0.0, 0)), options);
    scatter.resize(made.set.values.size());
    stated.resize(made.set.values.size());
    for (std::size_t i = 0; i < scatter.size(); ++i) {
      scatter[i] += std::norm(made.set.values[i] - clean.set.values[i]) / trials;
      stated[i] += (made.set.variance[i].real() + made.set.variance[i].imag()) / trials;
    }
  }
  std::vector<double> ratio;
  for (std::size_t i = 20; i < scatter.size(); ++i) ratio.push_back(scatter[i] / stated[i]);
  EXPECT_NEAR(median(ratio), 1.0, 0.3);
  EXPECT_LT(*std::ranges::max_element(ratio), 3.0);
  EXPECT_GT(*std::ranges::min_element(ratio), 1.0 / 3.0);
}

}  // namespace
}  // namespace jointid::records
