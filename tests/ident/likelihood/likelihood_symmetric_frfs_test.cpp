#include "ident/likelihood/data/symmetric_frfs.hpp"

#include <gtest/gtest.h>

#include "base/statistics.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {
namespace {

const Dofs both = dofs({"1:+X", "4:+X"});
const Blocks all_blocks{.nn = true, .jn = true, .jj = true};

/// Two lines of FRFs 1 and 4 in both roles with variances 1, 2, 3, … of real parts and tenfold of imaginary ones.
frf::FrfSet sample() {
  std::mt19937_64 random(3);
  frf::FrfSet set = random_set("a", {10.0, 20.0}, both, both, 1.0, random);
  set.header.noise = frf::NoiseRecord::variance;
  for (std::size_t i = 0; i < set.values.size(); ++i) set.variance.emplace_back(1.0 + double(i), 10.0 + 10.0 * double(i));
  return set;
}

SymmetricFrfs read(frf::FrfSystem& system, const Dofs& coordinates, const Blocks& blocks = all_blocks, const Scene& scene = {}) {
  SymmetricFrfs frfs(system, scene, coordinates, 1, blocks);
  const std::array<std::size_t, 2> lines = {0, 1};
  frfs.prepare(lines);
  frfs.read(lines);
  return frfs;
}

TEST(SymmetricFrfs, AveragesTwoMeasurementsByTheirVariances) {
  const frf::FrfSet set = sample();
  const auto system = memory_system("assembly", {set}, frf::Composition::merged);
  const SymmetricFrfs frfs = read(*system, both);
  const std::size_t one = set.index(1, 0, 1), other = set.index(1, 1, 0);
  const double va = set.variance[one].real(), vb = set.variance[other].real();
  for (const bool swapped : {false, true}) {
    const Measured m = frfs.at(1, swapped ? 1 : 0, swapped ? 0 : 1);
    EXPECT_NEAR(m.value.real(), (set.values[one].real() / va + set.values[other].real() / vb) / (1.0 / va + 1.0 / vb), 1e-14);
    EXPECT_NEAR(m.variance.real(), 1.0 / (1.0 / va + 1.0 / vb), 1e-14);
    EXPECT_NEAR(m.variance.imag(), 10.0 / (1.0 / va + 1.0 / vb), 1e-13);
    EXPECT_TRUE(m.averaged);
  }
  EXPECT_FALSE(frfs.at(1, 0, 0).averaged);
}

TEST(SymmetricFrfs, CopiesAreOneMeasurementWhateverTheirRounding) {
  for (const double rounding : {0.0, 1e-9}) {
    frf::FrfSet set = sample();
    const std::size_t one = set.index(0, 0, 1), other = set.index(0, 1, 0);
    set.values[other] = set.values[one] * (1.0 + rounding);
    set.variance[other] = set.variance[one];
    const auto system = memory_system("assembly", {set}, frf::Composition::merged);
    const Measured m = read(*system, both).at(0, 0, 1);
    EXPECT_NEAR(std::abs(m.value - set.values[one]), 0.0, 2e-9);
    EXPECT_EQ(m.variance, set.variance[one]);
    EXPECT_FALSE(m.averaged);
  }
}

TEST(SymmetricFrfs, OneOfTheTwoIsEnough) {
  frf::FrfSet set = sample();
  set.values[set.index(0, 0, 1)] = nan;
  set.variance[set.index(1, 1, 0)] = {nan, nan};
  set.values[set.index(1, 1, 1)] = nan;
  const auto system = memory_system("assembly", {set}, frf::Composition::merged);
  const SymmetricFrfs frfs = read(*system, both);
  EXPECT_EQ(frfs.at(0, 0, 1).value, set.values[set.index(0, 1, 0)]);
  EXPECT_EQ(frfs.at(1, 1, 0).value, set.values[set.index(1, 0, 1)]);
  EXPECT_FALSE(frfs.at(0, 0, 1).averaged || frfs.at(1, 0, 1).averaged);
  EXPECT_FALSE(frfs.at(1, 1, 1).known());
}

TEST(SymmetricFrfs, CarryTheSignsOfTheDofsAskedFor) {
  const frf::FrfSet set = sample();
  const auto system = memory_system("assembly", {set}, frf::Composition::merged);
  const SymmetricFrfs plain = read(*system, both), turned = read(*system, dofs({"1:-X", "4:+X"}));
  EXPECT_EQ(turned.at(0, 0, 1).value, -plain.at(0, 0, 1).value);
  EXPECT_EQ(turned.at(0, 0, 0).value, plain.at(0, 0, 0).value);
  EXPECT_EQ(turned.at(0, 0, 1).variance, plain.at(0, 0, 1).variance);
}

TEST(SymmetricFrfs, ReadTheirBlocksOnly) {
  const auto system = memory_system("assembly", {sample()}, frf::Composition::merged);
  const SymmetricFrfs frfs = read(*system, both, {.jn = true});
  EXPECT_EQ(frfs.entries_per_line(), 2u);
  EXPECT_TRUE(frfs.at(0, 0, 1).known() && frfs.at(0, 1, 0).known());
  EXPECT_FALSE(frfs.at(0, 0, 0).known() || frfs.at(0, 1, 1).known());
}

TEST(SymmetricFrfs, GiveTheVariancesOfOtherValuesByTheLaw) {
  frf::FrfSet set = sample();
  set.variance.clear();
  set.header.noise = frf::NoiseRecord::none;
  Scene scene;
  const frf::NoiseModel model{.kind = frf::NoiseKind::circular, .level = 0.1};
  scene.noise = NoiseSection{.model = "circular", .level = 0.1, .frf_model = model};
  const auto system = memory_system("assembly", {set}, frf::Composition::merged);
  SymmetricFrfs frfs = read(*system, both, all_blocks, scene);
  EXPECT_TRUE(frfs.variances_by_law());
  Symmetric<Complex> values(2, nan);
  values.at(0, 1) = {3.0, 4.0};
  frfs.variances_of(1, values);
  EXPECT_NEAR(frfs.variance(1, 0, false).real(), 0.01 * 25.0 / 2.0, 1e-15);
  EXPECT_NEAR(frfs.variance(0, 1, true).imag(), 0.01 * 25.0 / 4.0, 1e-15);
  EXPECT_TRUE(std::isnan(frfs.variance(0, 0, false).real()));
}

}  // namespace
}  // namespace jointid::ident
