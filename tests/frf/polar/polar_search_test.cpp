#include "frf/polar/polar_search.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "frf/polar/phase_unit.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A structure of few or many modes, of light or heavy, viscous or hysteretic damping; lines between resonances or all below them.
struct Structure {
  std::vector<double> hz, loss;
  std::vector<std::vector<double>> shape;  ///< [mode][DOF]
  std::vector<double> lines;
  bool hysteretic = false;
  int order = 0;  ///< 0 receptance, 1 mobility, 2 accelerance
};

double uniform(std::mt19937_64& random, double from, double to) { return std::uniform_real_distribution(from, to)(random); }
double decades(std::mt19937_64& random, double from, double to) { return std::pow(10.0, uniform(random, from, to)); }

Structure random_structure(std::mt19937_64& random, std::size_t dofs) {
  Structure out;
  const double first = decades(random, 0.0, 3.0), last = first * (1.0 + decades(random, -0.5, 1.5));
  const auto modes = std::uniform_int_distribution<std::size_t>(1, 8)(random);
  const bool is_static = uniform(random, 0.0, 1.0) < 0.15, same_sign = uniform(random, 0.0, 1.0) < 0.3;
  for (std::size_t r = 0; r < modes; ++r) {
    out.hz.push_back(is_static ? last * decades(random, 0.1, 2.0) : decades(random, std::log10(first) - 0.5, std::log10(last) + 0.5));
    out.loss.push_back(decades(random, -5.0, 0.3));
    out.shape.emplace_back();
    for (std::size_t i = 0; i < dofs; ++i) {
      const double value = std::normal_distribution<double>()(random);
      out.shape.back().push_back(same_sign ? std::abs(value) : value);
    }
  }
  const auto lines = std::uniform_int_distribution<std::size_t>(8, 300)(random);
  for (std::size_t k = 0; k < lines; ++k)
    out.lines.push_back(first + (last - first) * static_cast<double>(k) / static_cast<double>(lines - 1));
  out.hysteretic = uniform(random, 0.0, 1.0) < 0.4;
  out.order = std::uniform_int_distribution(0, 2)(random);
  return out;
}

std::vector<Complex> frf_of(const Structure& s, std::size_t i, std::size_t j) {
  constexpr double turn = 2.0 * std::numbers::pi;
  std::vector<Complex> out;
  for (const double f : s.lines) {
    const double w = turn * f;
    Complex h = 0.0;
    for (std::size_t r = 0; r < s.hz.size(); ++r) {
      const double own = turn * s.hz[r];
      const Complex damping = s.hysteretic ? Complex(0.0, s.loss[r] * own * own) : Complex(0.0, s.loss[r] * own * w);
      h += s.shape[r][i] * s.shape[r][j] / (own * own - w * w + damping);
    }
    out.push_back(h * std::pow(Complex(0.0, w), s.order));
  }
  return out;
}

std::vector<std::vector<Complex>> random_set(std::mt19937_64& random, int& order) {
  const std::size_t dofs = uniform(random, 0.0, 1.0) < 0.5 ? 1 : 3;
  const Structure structure = random_structure(random, dofs);
  order = structure.order;
  std::vector<std::vector<Complex>> out;
  for (std::size_t i = 0; i < dofs; ++i) {
    for (std::size_t j = 0; j <= i; ++j) out.push_back(frf_of(structure, i, j));
  }
  return out;
}

void add_noise(std::vector<std::vector<Complex>>& set, std::mt19937_64& random, double level) {
  std::normal_distribution<double> normal;
  for (auto& frf : set) {
    for (Complex& value : frf) value *= 1.0 + level * Complex(normal(random), normal(random));
  }
}

PolarSearch search_of(const std::vector<std::vector<Complex>>& set, bool mobility) {
  PolarSearch search(mobility ? Quantity::mobility : Quantity::receptance);
  for (const auto& frf : set) search.add(frf);
  return search;
}

std::vector<std::vector<Complex>> scaled(std::vector<std::vector<Complex>> set, Complex factor) {
  for (auto& frf : set) {
    for (Complex& value : frf) value *= factor;
  }
  return set;
}

double largest_part(const std::vector<std::vector<Complex>>& set, bool real) {
  double largest = 0.0;
  for (const auto& frf : set) {
    for (const Complex& value : frf) largest = std::max(largest, std::abs(real ? value.real() : value.imag()));
  }
  return largest;
}

enum class Turned { half_turns, from_zero, unwrapped };

/// Magnitudes and phases of a set.
std::vector<std::vector<Complex>> polar_of(std::vector<std::vector<Complex>> set, double per_turn, Turned turned) {
  for (auto& frf : set) {
    double before = 0.0;
    for (Complex& value : frf) {
      double phase = std::arg(value);
      if (turned == Turned::from_zero && phase < 0.0) phase += 2.0 * std::numbers::pi;
      if (turned == Turned::unwrapped) phase += 2.0 * std::numbers::pi * std::round((before - phase) / (2.0 * std::numbers::pi));
      before = phase;
      value = {std::abs(value), phase / (2.0 * std::numbers::pi) * per_turn};
    }
  }
  return set;
}

/// True FRFs in all units, of which the imaginary part, or the real one, ends just where a half turn or a right angle does: the worst that
/// can be. Some four in 10,000 such sets do look like phases that leap by a whole turn, so that sets are the same in every run.
TEST(PolarSearch, FindsTrueFrfsInOneOfAThousandSetsAtMost) {
  constexpr std::uint64_t sets = 1000;
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    std::mt19937_64 random(seed);
    int order = 0;
    std::vector<std::vector<Complex>> set = random_set(random, order);
    if (uniform(random, 0.0, 1.0) < 0.5) add_noise(set, random, decades(random, -5.0, -1.0));
    const double largest = largest_part(set, seed % 2 == 0);
    if (!(largest > 0.0)) continue;
    bool of_set = false;
    for (const double half : {std::numbers::pi, 180.0}) {
      for (const double end : {half, 0.5 * half, 2.0 * half, decades(random, -9.0, 6.0)}) {
        for (const double sign : {1.0, -1.0}) {
          const double below = 1.0 - decades(random, -9.0, -1.0);
          of_set = of_set || search_of(scaled(set, sign * end * below / largest), order == 1).finding().has_value();
        }
      }
    }
    found += of_set;
  }
  EXPECT_LE(found, 1U);
}

/// Free mass, spring and dashpot, and a spring of hysteretic damping: no resonance at all.
TEST(PolarSearch, NeverFindsStaticLines) {
  for (const double size : {std::numbers::pi, 180.0, 90.0, 1.0, 1e-6, 1e5}) {
    std::vector<Complex> mass, spring, loss;
    for (int k = 1; k <= 100; ++k) {
      mass.emplace_back(0.0, -size / k);
      spring.emplace_back(0.0, size * k / 100.0);
      loss.emplace_back(20.0 * size, -size);
    }
    for (const auto& frf : {mass, spring}) EXPECT_FALSE(search_of({frf}, true).finding()) << size;
    for (const bool mobility : {false, true}) EXPECT_FALSE(search_of({loss, loss}, mobility).finding()) << size;
  }
}

/// Three modes, 1 % damping, 400 lines; accelerances between 0.01 and 30 m/s²/N.
std::vector<std::vector<Complex>> beam(int order) {
  Structure beam{.hz = {45.0, 130.0, 260.0}, .loss = {0.02, 0.015, 0.02}, .shape = {{0.7, 0.4}, {0.5, -0.6}, {0.6, 0.5}}, .lines = {},
                 .hysteretic = false, .order = order};
  for (int k = 0; k < 400; ++k) beam.lines.push_back(10.0 + k);
  return {frf_of(beam, 0, 0), frf_of(beam, 0, 1), frf_of(beam, 1, 1)};
}

TEST(PolarSearch, FindsMagnitudesAndPhases) {
  for (const int order : {0, 1, 2}) {
    for (const double per_turn : {2.0 * std::numbers::pi, 360.0}) {
      for (const Turned turned : {Turned::half_turns, Turned::from_zero, Turned::unwrapped}) {
        std::vector<std::vector<Complex>> set = beam(order);
        std::mt19937_64 random(7);
        add_noise(set, random, 1e-3);
        const auto finding = search_of(polar_of(set, per_turn, turned), order == 1).finding();
        ASSERT_TRUE(finding) << order << " " << per_turn << " " << static_cast<int>(turned);
        EXPECT_THAT(*finding, AllOf(HasSubstr("magnitudes and phases"), HasSubstr("no first number is below 0")));
        EXPECT_FALSE(search_of(set, order == 1).finding());
      }
    }
  }
}

/// Less than magnitudes before phases: a leap of a whole turn is found, else phases that end at a half turn are a doubt.
TEST(PolarSearch, FindsPhasesBeforeMagnitudes) {
  std::vector<Complex> leap, level;
  for (int k = 0; k < 40; ++k) {
    leap.emplace_back(k < 20 ? 171.0 + 0.4 * k : -179.0 + 0.4 * (k - 20), 0.3 + 0.001 * k);
    level.emplace_back(k < 20 ? 0.5 : 179.5, 0.3 + 0.001 * k);
  }
  EXPECT_THAT(search_of({leap}, false).finding().value_or(""),
              AllOf(HasSubstr("phases in degrees and magnitudes: no second number is below 0"), HasSubstr("a whole turn")));
  EXPECT_FALSE(search_of({level}, false).finding());
  EXPECT_THAT(search_of({level}, false).doubt().value_or(""), HasSubstr("as if they were phases and magnitudes"));
  for (const int order : {0, 1, 2}) {
    EXPECT_FALSE(search_of({beam(order).front()}, order == 1).finding()) << order;
    EXPECT_FALSE(search_of({beam(order).front()}, order == 1).doubt()) << order;
  }
}

/// Magnitudes of small receptances in decibels, all below 0.
TEST(PolarSearch, FindsDecibelsAndPhases) {
  auto set = polar_of(beam(2), 360.0, Turned::half_turns);
  for (auto& frf : set) {
    for (Complex& value : frf) value = {20.0 * std::log10(value.real()) - 100.0, value.imag()};
  }
  EXPECT_THAT(search_of(set, false).finding().value_or(""), HasSubstr("in degrees: no first number is above 0"));
}

TEST(PolarSearch, DoubtsWhatOnlyMayBe) {
  std::vector<Complex> ramp;
  for (int k = 0; k < 20; ++k) ramp.emplace_back(20.0 + k, 178.0 * k / 19.0);
  EXPECT_FALSE(search_of({ramp}, false).finding());
  EXPECT_THAT(search_of({ramp}, false).doubt().value_or(""), HasSubstr("end at 178"));
  ramp[5] = {-0.1, 3.0};
  EXPECT_FALSE(search_of({ramp}, false).doubt());
}

TEST(PhaseUnit, IsThatOfTheNumbersWhereTheyLeaveNoOther) {
  const auto unit = [](int order, double per_turn, Turned turned) {
    PhaseUnit out;
    for (const auto& frf : polar_of(beam(order), per_turn, turned)) {
      std::vector<double> phases;
      for (const Complex& value : frf) phases.push_back(value.imag());
      out.add(phases);
    }
    return out.unit();
  };
  for (const int order : {0, 2}) {
    for (const Turned turned : {Turned::half_turns, Turned::from_zero}) {
      EXPECT_EQ(unit(order, 360.0, turned), AngleUnit::degrees) << order;
      EXPECT_EQ(unit(order, 2.0 * std::numbers::pi, turned), AngleUnit::radians) << order;
    }
    EXPECT_EQ(unit(order, 360.0, Turned::unwrapped), AngleUnit::degrees);
  }
  PhaseUnit few, ramp, small;
  few.add(std::vector<double>{-26.0, 53.0, 170.0, -170.0, 3.0, 4.0, 5.0});
  ramp.add(std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0});
  small.add(std::vector<double>(20, -0.5));
  EXPECT_EQ(few.unit(), AngleUnit::unstated);
  few.add(std::vector<double>{6.0});
  EXPECT_EQ(few.unit(), AngleUnit::degrees);
  EXPECT_EQ(ramp.unit(), AngleUnit::unstated);
  EXPECT_EQ(small.unit(), AngleUnit::unstated);
  EXPECT_EQ(PhaseUnit().unit(), AngleUnit::unstated);
}

TEST(PhaseUnit, ByItsLabel) {
  for (const char* label : {"deg", "[deg]", "Degrees", "°", "(°)", " DEG. ", "\xB0"})
    EXPECT_EQ(angle_unit(label), AngleUnit::degrees) << label;
  for (const char* label : {"rad", "(Radians)", "RAD"}) EXPECT_EQ(angle_unit(label), AngleUnit::radians) << label;
  for (const char* label : {"", "grad", "gon", "V", "turns"}) EXPECT_EQ(angle_unit(label), AngleUnit::unstated) << label;
}

}  // namespace
}  // namespace jointid::frf
