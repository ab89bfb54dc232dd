#include "frf/noise/wild_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace jointid::frf {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

FrfSet set_of(std::size_t lines, std::size_t responses, double first_hz, double step_hz) {
  FrfSet set;
  set.header.file = "test";
  for (std::size_t l = 0; l < lines; ++l) set.header.frequency_hz.push_back(first_hz + step_hz * static_cast<double>(l));
  for (std::size_t r = 0; r < responses; ++r) set.header.response.push_back({static_cast<std::int64_t>(r + 1), Direction::z, 1});
  set.header.reference = {{1, Direction::z, 1}};
  set.values.assign(lines * responses, {});
  return set;
}

/// Receptances of two modes and a rigid-body one; response r moves with the second mode at another amplitude.
FrfSet structure(std::size_t lines, std::size_t responses, double first_hz, double step_hz, double damping) {
  FrfSet set = set_of(lines, responses, first_hz, step_hz);
  for (std::size_t l = 0; l < lines; ++l) {
    const double f = set.header.frequency_hz[l];
    for (std::size_t r = 0; r < responses; ++r) {
      const auto mode = [&](double own, double amplitude) {
        return amplitude / Complex(own * own - f * f, 2.0 * damping * own * f);
      };
      const double share = 1.0 - 0.3 * static_cast<double>(r);
      set.values[set.index(l, r, 0)] =
          (f > 0.0 ? Complex(-1.0 / (f * f)) : Complex(nan, nan)) + mode(100.0, 1.0) + mode(250.0, share);
    }
  }
  return set;
}

WildValues search(const FrfSet& set) {
  WildSearch search(set.header);
  const std::size_t half = set.header.lines() / 2 * set.header.entries();
  search.add(std::span(set.values).first(half));
  search.add(std::span(set.values).subspan(half));
  return search.finish();
}

TEST(WildValues, ResonancesAntiresonancesAndTheFallFromZeroHertzAreNone) {
  for (const double damping : {0.0, 1e-6, 1e-4, 0.01, 0.2}) {
    for (const double step : {0.5, 1.0, 7.0}) {
      const WildValues wild = search(structure(400, 6, 0.0, step, damping));
      for (const WildValue& each : wild.found) {  // an undamped resonance on a line is beyond all bounds
        const bool infinite = damping == 0.0 && each.kind < WildKind::large;
        EXPECT_TRUE(infinite || (damping < 1e-5 && each.kind == WildKind::large && each.factor > 1e5))
            << damping << ' ' << step << ' ' << each.line;
      }
    }
  }
}

/// On a line at an end a value is a resonance where a third of all other FRFs rise, without it.
TEST(WildValues, AtAnEndTheOthersAreCountedWithoutTheFrfItself) {
  for (const std::size_t line : {0U, 1U, 10U, 11U}) {
    for (std::size_t frfs = 2; frfs < 12; ++frfs) {
      for (std::size_t risen = 1; risen <= frfs; ++risen) {
        FrfSet set = set_of(12, frfs, 100.0, 1.0);
        for (std::size_t i = 0; i < set.values.size(); ++i) set.values[i] = Complex(1.0, 0.01 * static_cast<double>(i % 7));
        for (std::size_t r = 0; r < risen; ++r) set.values[set.index(line, r, 0)] = 3000.0;
        const bool resonance = risen > 1 && 3 * (risen - 1) >= frfs - 1;
        EXPECT_EQ(search(set).found.empty(), resonance) << line << ' ' << frfs << ' ' << risen;
      }
    }
  }
}

/// Two points, both hit, of one mode of hardly any damping on line `on`, and of a second one above.
FrfSet square_structure(std::size_t on, double product) {
  FrfSet set = set_of(12, 2, 20.0, 16.0);
  set.header.reference.push_back({2, Direction::z, 1});
  set.values.assign(set.header.lines() * 4, {});
  const double own = set.header.frequency_hz[on] + 0.01;
  for (std::size_t l = 0; l < set.header.lines(); ++l) {
    const double f = set.header.frequency_hz[l];
    const Complex first = 1.0 / Complex(own * own - f * f, 1e-4 * own * own), second = 1.0 / Complex(9e4 - f * f, 90.0);
    for (std::size_t k = 0; k < 4; ++k)
      set.values[set.index(l, k / 2, k % 2)] = (k == 1 || k == 2 ? product : 1.0) * first + second;
  }
  return set;
}

TEST(WildValues, ResonanceOnTheFirstOrLastLinesLiftsAllFrfsAndIsNone) {
  for (const std::size_t on : {0UL, 1UL, 10UL, 11UL}) {
    FrfSet set = square_structure(on, 0.8);
    EXPECT_GT(std::abs(set.values[set.index(on, 0, 0)]), 400.0 * std::abs(set.values[set.index(on == 0 ? 2 : on - 1, 0, 0)]))
        << on;
    EXPECT_TRUE(search(set).found.empty()) << on;
    set = structure(200, 3, 5.0, 2.0, 0.01);
    set.values[set.index(on, 1, 0)] *= 1e4;
    ASSERT_EQ(search(set).found.size(), 1u) << on;
  }
}

/// A row of joints that lets waves pass on one line alone: 5 times less beside it from sensor to sensor. What is wild besides is
/// found.
TEST(WildValues, WhatPassesARowOfJointsOnOneLineIsNone) {
  constexpr std::size_t lines = 9, sensors = 12, passing = 4;
  FrfSet set = set_of(lines, sensors, 100.0, 20.0);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> spread(0.5, 1.5);
  for (std::size_t l = 0; l < lines; ++l) {
    for (std::size_t r = 0; r < sensors; ++r) {
      const double loss = l == passing ? 0.0 : static_cast<double>(r);
      set.values[set.index(l, r, 0)] = std::polar(1e-6 * spread(random) * std::pow(5.0, -loss), 6.0 * spread(random));
    }
  }
  EXPECT_TRUE(search(set).found.empty()) << search(set).found.front().response;
  for (const std::size_t line : {passing, std::size_t{2}}) {
    FrfSet wild = set;
    wild.values[wild.index(line, 3, 0)] *= 1e12;
    const WildValues found = search(wild);
    ASSERT_EQ(found.found.size(), 1U) << line;
    EXPECT_EQ(found.found[0].response, 3U);
    EXPECT_EQ(found.found[0].line, line);
  }
  FrfSet damaged = set;  // the whole line
  for (std::size_t r = 0; r < sensors; ++r) damaged.values[damaged.index(2, r, 0)] *= 1e6;
  ASSERT_EQ(search(damaged).found.size(), 1U);
  EXPECT_EQ(search(damaged).found[0].response, npos);
}

TEST(WildValues, FrfThatIsSmallBothWaysIsAnAntiresonance) {
  FrfSet set = square_structure(1, 0.8);
  const Complex there = set.values[set.index(6, 0, 1)];
  set.values[set.index(6, 0, 1)] = 1e-4 * there;
  ASSERT_EQ(search(set).found.size(), 1u);
  EXPECT_EQ(search(set).found[0].kind, WildKind::small);
  set.values[set.index(6, 1, 0)] = 0.01 * there;
  EXPECT_TRUE(search(set).found.empty());
}

TEST(WildValues, OneWildValueIsFoundOnAnyLineAndByItsFactor) {
  const FrfSet clean = structure(200, 3, 5.0, 2.0, 0.01);
  for (const double factor : {1e3, 1e6, 1e30}) {
    for (const std::size_t line : {0UL, 1UL, 30UL, 100UL, 198UL, 199UL}) {
      FrfSet set = clean;
      set.values[set.index(line, 1, 0)] *= Complex(0.6, 0.8) * factor;
      const WildValues wild = search(set);
      ASSERT_EQ(wild.found.size(), 1U) << factor << ' ' << line;
      const WildValue& only = wild.found.front();
      EXPECT_EQ(only.kind, WildKind::large);
      EXPECT_EQ(only.response, 1U);
      EXPECT_EQ(only.reference, 0U);
      EXPECT_EQ(only.line, line);
      EXPECT_EQ(only.last_line, line);
      EXPECT_EQ(only.value, set.values[set.index(line, 1, 0)]);
      EXPECT_GT(only.factor, 0.1 * factor);
      EXPECT_LT(only.factor, 10.0 * factor);
    }
  }
}

TEST(WildValues, NeighbouringWildValuesAreOneRun) {
  FrfSet set = structure(200, 3, 5.0, 2.0, 0.01);
  for (const std::size_t line : {60UL, 61UL, 62UL}) set.values[set.index(line, 2, 0)] *= 4000.0;
  const WildValues wild = search(set);
  ASSERT_EQ(wild.found.size(), 1U);
  EXPECT_EQ(wild.found.front().line, 60U);
  EXPECT_EQ(wild.found.front().last_line, 62U);
}

TEST(WildValues, DropoutsAreFoundAndTheEndsLeftOut) {
  FrfSet set = structure(200, 3, 5.0, 2.0, 0.01);
  for (const std::size_t line : {0UL, 70UL, 71UL, 120UL, 199UL}) set.values[set.index(line, 0, 0)] = {};
  set.values[set.index(150, 1, 0)] *= 1e-4;
  const WildValues wild = search(set);
  ASSERT_EQ(wild.found.size(), 3U);
  EXPECT_EQ(wild.found[0].line, 70U);
  EXPECT_EQ(wild.found[0].last_line, 71U);
  EXPECT_EQ(wild.found[1].line, 120U);
  EXPECT_EQ(wild.found[2].line, 150U);
  EXPECT_EQ(wild.found[2].response, 1U);
  for (const WildValue& each : wild.found) EXPECT_EQ(each.kind, WildKind::small);
}

TEST(WildValues, NumbersThatAreNoneAreNamedButNotWholeFrfs) {
  FrfSet set = structure(50, 3, 0.0, 2.0, 0.01);  // NaN at 0 Hz
  for (std::size_t l = 0; l < 50; ++l) set.values[set.index(l, 2, 0)] = {nan, nan};
  set.values[set.index(7, 0, 0)] = {nan, 0.0};
  set.values[set.index(8, 0, 0)] = {1.0, nan};
  set.values[set.index(20, 1, 0)] = {inf, 0.0};
  for (const std::size_t r : {0UL, 1UL}) set.values[set.index(30, r, 0)] = {nan, nan};
  const WildValues wild = search(set);
  ASSERT_EQ(wild.found.size(), 3U);
  EXPECT_EQ(wild.found[0].kind, WildKind::not_a_number);
  EXPECT_EQ(wild.found[0].line, 7U);
  EXPECT_EQ(wild.found[0].last_line, 8U);
  EXPECT_EQ(wild.found[1].line, 30U);
  EXPECT_EQ(wild.found[1].response, npos) << "all FRFs that have values";
  EXPECT_EQ(wild.found[2].kind, WildKind::infinite);
  EXPECT_EQ(wild.found[2].line, 20U);
  EXPECT_EQ(wild.found[2].response, 1U);
}

TEST(WildValues, RoundingOfAnFrfThatIsZeroIsNone) {
  FrfSet set = structure(200, 3, 5.0, 2.0, 0.01);
  for (std::size_t l = 0; l < 200; ++l) set.values[set.index(l, 2, 0)] *= 1e-17 * (l % 50 == 7 ? 1e4 : 1.0);
  EXPECT_TRUE(search(set).found.empty());
}

TEST(WildValues, NoiseAndZerosAreNone) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  FrfSet noise = set_of(2000, 50, 10.0, 1.0);
  for (Complex& value : noise.values) value = {normal(generator), normal(generator)};
  for (std::size_t l = 0; l < 2000; ++l) noise.values[noise.index(l, 3, 0)] = {};
  for (std::size_t l = 500; l < 900; ++l) noise.values[noise.index(l, 4, 0)] = {};  // a band that was not measured
  EXPECT_LE(search(noise).found.size(), 1U);
  EXPECT_TRUE(search(set_of(3, 2, 1.0, 1.0)).found.empty());
  EXPECT_TRUE(search(set_of(1, 1, 0.0, 1.0)).found.empty());
}

}  // namespace
}  // namespace jointid::frf
