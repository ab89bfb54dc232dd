#include "frf/noise/noise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/error.hpp"
#include "base/random.hpp"
#include "frf/noise/polluter.hpp"
#include "frf/set/h1.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t many = 40000;

/// One response, one reference, `lines` lines of the same value.
FrfSet constant_set(Complex value, std::size_t lines = many) {
  FrfSet set;
  set.header.response = {Dof::parse("1:+Y")};
  set.header.reference = {Dof::parse("2:+Y")};
  for (std::size_t i = 0; i < lines; ++i) set.header.frequency_hz.push_back(static_cast<double>(i));
  set.values.assign(lines, value);
  return set;
}

/// Sample mean and variance of f(entry) and their standard errors.
struct Sample {
  double mean = 0.0, variance = 0.0, mean_error = 0.0, variance_error = 0.0;
};

Sample sample(std::size_t count, const std::function<double(std::size_t)>& f) {
  double sum = 0.0, second = 0.0, fourth = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += f(i);
  const double n = static_cast<double>(count);
  const double mean = sum / n;
  for (std::size_t i = 0; i < count; ++i) {
    const double square = (f(i) - mean) * (f(i) - mean);
    second += square / n;
    fourth += square * square / n;
  }
  return {mean, second, std::sqrt(second / n), std::sqrt((fourth - second * second) / n)};
}

void expect_mean_and_variance(const Sample& s, double mean, double variance) {
  EXPECT_NEAR(s.mean, mean, 4.0 * s.mean_error);
  EXPECT_NEAR(s.variance, variance, 4.0 * s.variance_error);
}

class ProportionalNoise : public testing::TestWithParam<NoiseKind> {};

TEST_P(ProportionalNoise, HasTheMeanAndVarianceOfItsLaw) {
  const Complex exact(3.0, -2.0);
  const FrfSet noisy = polluted(constant_set(exact), {.kind = GetParam(), .level = 0.05}, 7, 3);
  const bool circular = GetParam() == NoiseKind::circular;
  const double p2 = 0.05 * 0.05;
  expect_mean_and_variance(sample(many, [&](std::size_t i) { return noisy.values[i].real(); }), 3.0,
                           circular ? p2 * 13.0 / 2.0 : p2 / 3.0 * 9.0);
  expect_mean_and_variance(sample(many, [&](std::size_t i) { return noisy.values[i].imag(); }), -2.0,
                           circular ? p2 * 13.0 / 2.0 : p2 / 3.0 * 4.0);
  const Sample product = sample(many, [&](std::size_t i) {
    return (noisy.values[i].real() - exact.real()) * (noisy.values[i].imag() - exact.imag());
  });
  EXPECT_NEAR(product.mean, 0.0, 4.0 * product.mean_error);
}

TEST_P(ProportionalNoise, RecordsTheVarianceOnRequestOnly) {
  NoiseModel model{.kind = GetParam(), .level = 0.05};
  const FrfSet silent = polluted(constant_set({3.0, -2.0}), model, 7, 3);
  EXPECT_TRUE(silent.variance.empty());
  EXPECT_EQ(silent.header.noise, NoiseRecord::none);
  model.record_variance = true;
  const FrfSet noisy = polluted(constant_set({3.0, -2.0}), model, 7, 3);
  EXPECT_EQ(noisy.header.noise, NoiseRecord::variance);
  EXPECT_EQ(noisy.values, silent.values);
  const Sample parts = sample(many, [&](std::size_t i) { return noisy.values[i].real(); });
  const Sample recorded = sample(many, [&](std::size_t i) { return noisy.variance[i].real(); });
  EXPECT_NEAR(recorded.mean / parts.variance, 1.0, 0.05);
}

TEST_P(ProportionalNoise, ReciprocalEntriesShareTheirNoise) {
  FrfSet set = constant_set({3.0, -2.0}, 5);
  set.header.response = {Dof::parse("1:+Y"), Dof::parse("2:+Y"), Dof::parse("3:+Y")};
  set.header.reference = {Dof::parse("2:+Y"), Dof::parse("1:-Y")};
  set.values.assign(30, {3.0, -2.0});
  const FrfSet noisy = polluted(set, {.kind = GetParam(), .level = 0.05}, 1, 0);
  for (std::size_t line = 0; line < 5; ++line) {
    EXPECT_EQ(noisy.values[set.index(line, 0, 0)], noisy.values[set.index(line, 1, 1)]);
    EXPECT_NE(noisy.values[set.index(line, 0, 1)], noisy.values[set.index(line, 1, 0)]);
    EXPECT_NE(noisy.values[set.index(line, 2, 0)], noisy.values[set.index(line, 2, 1)]);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ProportionalNoise,
                         testing::Values(NoiseKind::uniform, NoiseKind::gaussian, NoiseKind::circular),
                         [](const auto& kind) { return name(kind.param); });

TEST(Noise, UniformFactorsStayWithinTheirBounds) {
  const FrfSet noisy = polluted(constant_set({1.0, 1.0}), {.level = 0.05}, 2, 0);
  for (const Complex& value : noisy.values) {
    ASSERT_LE(std::abs(value.real() - 1.0), 0.05);
    ASSERT_LE(std::abs(value.imag() - 1.0), 0.05);
  }
}

TEST(Noise, HammerHasTheVarianceOfH1AndACoherenceThatTellsIt) {
  const double coherence = 0.98;
  const FrfSet noisy = polluted(constant_set({3.0, -2.0}),
                                {.kind = NoiseKind::hammer, .coherence = coherence, .averages = 6}, 4, 1);
  const double variance = 13.0 * (1.0 - coherence) / (coherence * 5.0);
  expect_mean_and_variance(sample(many, [&](std::size_t i) { return noisy.values[i].real(); }), 3.0,
                           variance / 2.0);
  expect_mean_and_variance(sample(many, [&](std::size_t i) { return noisy.values[i].imag(); }), -2.0,
                           variance / 2.0);
  EXPECT_EQ(noisy.header.noise, NoiseRecord::coherence);
  EXPECT_EQ(noisy.header.averages, 6.0);
  const Sample told = sample(many, [&](std::size_t i) {
    return std::norm(noisy.values[i]) * (1.0 - noisy.coherence[i]) / (noisy.coherence[i] * 5.0);
  });
  EXPECT_NEAR(told.mean, variance, 4.0 * told.mean_error);
}

TEST(Noise, HammerUsesTheCoherenceOfTheSet) {
  FrfSet set = constant_set({3.0, -2.0}, 2);
  set.coherence = {1.0, 0.5};
  const FrfSet noisy = polluted(set, {.kind = NoiseKind::hammer}, 4, 1);
  EXPECT_EQ(noisy.values[0], set.values[0]);
  EXPECT_EQ(noisy.coherence[0], 1.0);
  EXPECT_NE(noisy.values[1], set.values[1]);
}

TEST(Noise, OfAnEntryDoesNotDependOnTheOthers) {
  FrfSet set = constant_set({3.0, -2.0}, 10);
  const FrfSet all = polluted(set, {}, 5, 2);
  for (std::size_t i = 0; i < 9; ++i) set.values[i] = Complex(8.0 + static_cast<double>(i), 1.0);
  EXPECT_EQ(polluted(set, {}, 5, 2).values[9], all.values[9]);
}

TEST(Noise, StreamsDifferAndRepeat) {
  const FrfSet set = constant_set({3.0, -2.0});
  const FrfSet first = polluted(set, {}, 5, 2);
  EXPECT_EQ(first.values, polluted(set, {}, 5, 2).values);
  for (const FrfSet& other : {polluted(set, {}, 6, 2), polluted(set, {}, 5, 3), polluted(set, {}, 5, 2, 1)}) {
    const Sample product = sample(
        many, [&](std::size_t i) { return (first.values[i].real() - 3.0) * (other.values[i].real() - 3.0); });
    EXPECT_NEAR(product.mean, 0.0, 4.0 * product.mean_error);
  }
}

TEST(Noise, WhatIsNotMeasuredStaysSo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const NoiseKind kind : {NoiseKind::uniform, NoiseKind::circular, NoiseKind::hammer}) {
    EXPECT_TRUE(std::isnan(polluted(constant_set({nan, nan}, 1), {.kind = kind}, 1, 0).values[0].real()));
  }
}

/// Two responses at nodes 1 m apart, one reference, `lines` lines.
FrfSet two_nodes(std::size_t lines) {
  FrfSet set;
  set.header.response = {Dof::parse("1:+Y"), Dof::parse("2:+Y")};
  set.header.reference = {Dof::parse("7:+Y")};
  set.header.nodes = {{1, {0.0, 0.0, 0.0}}, {2, {1.0, 0.0, 0.0}}};
  for (std::size_t i = 0; i < lines; ++i) set.header.frequency_hz.push_back(1.0 + static_cast<double>(i));
  for (std::size_t i = 0; i < lines; ++i) set.values.insert(set.values.end(), {Complex(1.0, 0.0), Complex(3.0, 0.0)});
  return set;
}

TEST(Noise, FloorIsConstantInTheQuantityOfTheSet) {
  FrfSet set = constant_set({2.0, 0.0});
  for (double& f : set.header.frequency_hz) f += 1.0;
  set.header.quantity = Quantity::accelerance;
  const FrfSet noisy = polluted(set, {.level = 0.0, .floor = 0.1}, 3, 1);
  double rms = 0.0;
  const auto accelerance = [&](std::size_t i, Complex h) {
    return h * from_receptance(Quantity::accelerance, set.header.frequency_hz[i]);
  };
  for (std::size_t i = 0; i < many; ++i) rms += std::norm(accelerance(i, set.values[i])) / static_cast<double>(many);
  const auto error = [&](std::size_t i) { return accelerance(i, noisy.values[i] - set.values[i]).real(); };
  expect_mean_and_variance(sample(many, error), 0.0, 0.01 * rms / 2.0);
  expect_mean_and_variance(sample(many / 10, error), 0.0, 0.01 * rms / 2.0);
}

TEST(Noise, GrossErrorsFallOnTheirShareOfTheLines) {
  const NoiseModel model{.level = 0.01, .gross = {.share = 0.1, .factor = 20.0}};
  const FrfSet noisy = polluted(constant_set({1.0, 1.0}), model, 3, 1);
  const Sample far = sample(many, [&](std::size_t i) { return std::abs(noisy.values[i].real() - 1.0) > 0.01 ? 1.0 : 0.0; });
  EXPECT_NEAR(far.mean, 0.1 * 0.95, 4.0 * far.mean_error);
}

TEST(Noise, AWrongDirectionFlipsADofOnAllLines) {
  int flipped = 0;
  for (std::uint64_t trial = 0; trial < 400; ++trial) {
    const FrfSet noisy = polluted(two_nodes(3), {.level = 0.0, .sign_errors = 0.25}, 1, trial);
    for (std::size_t i = 2; i < 6; ++i) EXPECT_EQ(noisy.values[i], noisy.values[i - 2]);
    flipped += noisy.values[0].real() * noisy.values[1].real() < 0.0;
  }
  EXPECT_NEAR(flipped / 400.0, 2.0 * 0.25 * 0.75, 4.0 * std::sqrt(0.375 * 0.625 / 400.0));
}

TEST(Noise, AWrongPlaceMixesWithTheNeighbour) {
  const Sample moved = sample(4000, [](std::size_t trial) {
    return polluted(two_nodes(1), {.level = 0.0, .position_errors = 0.01}, 1, trial).values[0].real();
  });
  expect_mean_and_variance(moved, 1.0, 4e-4);
}

TEST(Noise, OfAnExcerptIsThatOfTheWhole) {
  FrfSet set = two_nodes(5);
  set.header.reference.push_back(Dof::parse("1:-Y"));
  set.values.assign(20, Complex(1.0, 2.0));
  const auto source = from_memory(set);
  const std::array<std::size_t, 2> lines = {1, 4}, references = {1, 0};
  const std::array<std::size_t, 1> responses = {1};
  const Excerpt part = excerpt(*source, {lines, responses, references});
  for (const NoiseKind kind : {NoiseKind::uniform, NoiseKind::circular, NoiseKind::hammer}) {
    const FrfSet whole_noisy = polluted(set, {.kind = kind}, 9, 4, 2);
    FrfSet noisy = part.set;
    Polluter(part, {.kind = kind}).pollute(noisy, {9, 4, 2});
    EXPECT_EQ(noisy.values[0], whole_noisy.values[set.index(1, 1, 1)]);
    EXPECT_EQ(noisy.values[3], whole_noisy.values[set.index(4, 1, 0)]);
  }
}

TEST(H1, OverlappingAveragesAreWorthWhatWelchSays) {
  EXPECT_DOUBLE_EQ(effective_averages(20, 0.0, Window::hann), 20.0);
  EXPECT_NEAR(effective_averages(1000, 0.5, Window::hann), 1000.0 / (1.0 + 2.0 * 0.999 / 36.0), 1e-9);
  EXPECT_NEAR(effective_averages(100000, 0.5, Window::rectangular), 100000.0 / 1.5, 1.0);
  EXPECT_DOUBLE_EQ(h1_variance({3.0, 4.0}, 0.5, 6.0), 5.0);
}

TEST(Noise, ModelsOutsideTheirRangeAreErrors) {
  const FrfSet set = constant_set({1.0, 0.0}, 1);
  EXPECT_THROW(polluted(set, {.level = 1.0}, 1, 0), InputError);
  EXPECT_THROW(polluted(set, {.level = std::nan("")}, 1, 0), InputError);
  EXPECT_THROW(polluted(set, {.kind = NoiseKind::hammer, .averages = 1}, 1, 0), InputError);
  EXPECT_THROW(polluted(set, {.kind = NoiseKind::hammer, .coherence = 0.0}, 1, 0), InputError);
}

TEST(Noise, NamesAreParsedAndSuggested) {
  EXPECT_EQ(parse_noise_kind("circular"), NoiseKind::circular);
  try {
    parse_noise_kind("gausian");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("gaussian"));
  }
}

/// Known answer of Random123's kat_vectors for philox4x64-10 with counter and key zero: 16554d9eca36314c …
TEST(RandomNumbers, FollowThePublishedPhilox) {
  const auto u = uniform_numbers({.seed = 0, .trial = 0, .set = 0}, 0, 0);
  EXPECT_DOUBLE_EQ(u[0], std::ldexp(static_cast<double>(0x16554d9eca36314cULL >> 12) + 0.5, -52));
  EXPECT_DOUBLE_EQ(u[1], std::ldexp(static_cast<double>(0xdb20fe9d672d0fdcULL >> 12) + 0.5, -52));
}

}  // namespace
}  // namespace jointid::frf
