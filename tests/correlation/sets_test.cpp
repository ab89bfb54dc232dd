// Sets of FRFs and modes of two sources: signs, gaps, noise, what they do not share.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "correlation/correlated_frfs.hpp"
#include "correlation/correlated_modes.hpp"
#include "correlation/expanded_frfs.hpp"

namespace jointid::correlation {
namespace {

using Complex = std::complex<double>;

std::vector<frf::Dof> dofs(std::initializer_list<const char*> names) {
  std::vector<frf::Dof> out;
  for (const char* name : names) out.push_back(frf::Dof::parse(name));
  return out;
}

/// Random receptances, reciprocal.
frf::FrfSet drawn(std::vector<frf::Dof> of, unsigned seed, std::size_t lines = 30) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  frf::FrfSet out;
  out.header.file = "drawn" + std::to_string(seed);
  for (std::size_t i = 0; i < lines; ++i) out.header.frequency_hz.push_back(10.0 + double(i));
  out.header.response = out.header.reference = std::move(of);
  const std::size_t n = out.header.response.size();
  out.values.resize(lines * n * n);
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t c = 0; c <= r; ++c)
        out.values[out.index(line, r, c)] = out.values[out.index(line, c, r)] = Complex(normal(generator), normal(generator));
    }
  }
  return out;
}

const FrfAgreement& of(const CorrelatedFrfs& found, const char* response, const char* reference) {
  for (const FrfAgreement& each : found.frfs) {
    if (each.response.name() == response && each.reference.name() == reference) return each;
  }
  throw std::out_of_range(response);
}

TEST(CorrelatedSets, OneSensorTurnedAndOneOfHalfTheGainAreNamed) {
  const frf::FrfSet one = drawn(dofs({"1:+X", "2:+X", "3:+X"}), 1);
  frf::FrfSet other = drawn(dofs({"3:+X", "1:-X", "2:+X"}), 2);
  for (std::size_t line = 0; line < one.header.lines(); ++line) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t place[] = {2, 0, 1};
        const double sign = (r == 1 ? -1.0 : 1.0) * (c == 1 ? -1.0 : 1.0);  // what 1:-X asks for
        other.values[other.index(line, r, c)] = sign * (r == 0 ? 0.5 : 1.0) * one.values[one.index(line, place[r], place[c])];
      }
    }
  }
  const CorrelatedFrfs found = correlate(one, other);
  EXPECT_NEAR(of(found, "1:+X", "2:+X").coherence, 1.0, 1e-14);
  EXPECT_NEAR(of(found, "1:+X", "2:+X").error_db, 0.0, 1e-12);
  EXPECT_NEAR(of(found, "3:+X", "2:+X").frac, 1.0, 1e-14);
  EXPECT_NEAR(of(found, "3:+X", "2:+X").error_db, 6.0206, 1e-4);
  EXPECT_NEAR(of(found, "3:+X", "2:+X").lac, 0.8, 1e-12);
  EXPECT_TRUE(std::isnan(found.frfs[0].chi_square));
  EXPECT_EQ(found.freedom, 0.0);
  EXPECT_LT(found.lines[0].shape, 1.0 - 1e-6);
}

/// χ² of noise alone is its degrees of freedom: the variances of both sets add.
TEST(CorrelatedSets, ChiSquareCountsTheNoiseOfBoth) {
  constexpr double level = 0.02;
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0.0, level);
  frf::FrfSet one = drawn(dofs({"1:+X", "2:+X"}), 3, 2000), other = one;
  for (frf::FrfSet* set : {&one, &other}) {
    set->header.noise = frf::NoiseRecord::variance;
    set->variance.assign(set->values.size(), {level * level, level * level});
    for (Complex& value : set->values) value += Complex(normal(generator), normal(generator));
  }
  const CorrelatedFrfs found = correlate(one, other);
  EXPECT_EQ(found.freedom, 2.0 * 4.0 * 2000.0);
  EXPECT_NEAR(found.chi_square / found.freedom, 1.0, 0.04);  // four deviations
  EXPECT_GT(found.frfs[0].frac, 0.99);
}

TEST(CorrelatedSets, GapsAreLeftOut) {
  frf::FrfSet one = drawn(dofs({"1:+X"}), 4);
  frf::FrfSet other = one;
  one.values[3] = {std::nan(""), 0.0};
  const CorrelatedFrfs found = correlate(one, other);
  EXPECT_EQ(found.frfs[0].lines, 29u);
  EXPECT_NEAR(found.frfs[0].frac, 1.0, 1e-14);
  EXPECT_TRUE(std::isnan(found.lines[3].shape));
}

void expect_refused(const frf::FrfSet& one, const frf::FrfSet& other, const std::string& place) {
  try {
    correlate(one, other);
    FAIL() << "no error for " << place;
  } catch (const InputError& error) {
    EXPECT_EQ(error.parts().place, place);
    EXPECT_EQ(error.parts().file, other.header.file);
  }
}

TEST(CorrelatedSets, NothingInCommonIsAnError) {
  const frf::FrfSet one = drawn(dofs({"1:+X"}), 1);
  expect_refused(one, drawn(dofs({"2:+X"}), 2), "responses");
  frf::FrfSet shifted = drawn(dofs({"1:+X"}), 3);
  for (double& hz : shifted.header.frequency_hz) hz += 0.5;
  expect_refused(one, shifted, "frequency lines");
  try {
    (void)shapes_over_lines(one, one, frf::Dof::parse("7:+X"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.parts().place, "FDAC");
    EXPECT_THAT(error.parts().problem, testing::StartsWith("7:+X is no reference of both"));
    EXPECT_EQ(error.parts().remedy, "name one of 1:+X");
  }
}

TEST(CorrelatedSets, FdacOfOneReference) {
  const frf::FrfSet one = drawn(dofs({"1:+X", "2:+X", "3:+X"}), 6);
  const ShapesOverLines found = shapes_over_lines(one, one, frf::Dof::parse("2:-X"));
  EXPECT_EQ(found.frequency_hz, one.header.frequency_hz);
  EXPECT_LT((found.fdac.diagonal().array() - 1.0).abs().maxCoeff(), 1e-14);
  EXPECT_LT(found.fdac(0, 1), 1.0 - 1e-6);
}

frf::Uff55Mode mode(double hz, std::vector<frf::Dof> at, std::vector<Complex> shape) {
  frf::Uff55Mode out;
  out.frequency_hz = hz;
  out.dofs = std::move(at);
  out.shape = std::move(shape);
  return out;
}

TEST(CorrelatedSets, ModesAreComparedWhereAllHaveThem) {
  const ModeFile one{"test.uff",
                     {mode(10.0, dofs({"1:+X", "2:+X", "3:+X"}), {1.0, 2.0, 3.0}),
                      mode(20.0, dofs({"1:+X", "2:+X", "3:+X"}), {1.0, -1.0, 0.5})}};
  const ModeFile other{
      "fe.uff",
      {mode(21.0, dofs({"3:+X", "2:-X", "1:+X"}), {1.0, 2.0, 2.0}), mode(9.0, dofs({"3:+X", "2:-X", "1:+X"}), {3.0, -2.0, 1.0})}};
  const CorrelatedModes found = correlate(one, other);
  EXPECT_EQ(found.partner[0], std::optional<std::size_t>(1));
  EXPECT_EQ(found.partner[1], std::optional<std::size_t>(0));
  EXPECT_NEAR(found.mac(0, 1), 1.0, 1e-14);
  EXPECT_NEAR(found.mac(1, 0), 1.0, 1e-14);
  EXPECT_LT((found.comac.array() - 1.0).abs().maxCoeff(), 1e-14);
  EXPECT_LT(found.ecomac.maxCoeff(), 1e-14);
}

TEST(CorrelatedSets, DirectionsThatOnlyFillADatasetAreLeftOut) {
  const std::vector<frf::Dof> three = dofs({"1:+X", "1:+Y", "2:+X"});
  const ModeFile file{"test.uff", {mode(10.0, three, {1.0, 0.0, 3.0}), mode(20.0, three, {1.0, 0.0, 0.0})}};
  EXPECT_EQ(frf::names(dofs_of_all(file)), (std::vector<std::string>{"1:+X", "2:+X"}));
}

TEST(CorrelatedSets, ExpandedFrfsHaveTheOverlayAtItsCoordinates) {
  const frf::FrfSet parent = drawn(dofs({"1:+X", "2:+X", "3:+X", "4:+X"}), 7), truth = drawn(dofs({"3:-X", "1:+X"}), 8);
  for (const Semm way : {Semm::basic, Semm::extended}) {
    const ExpandedFrfs found = expanded(parent, truth, way);
    EXPECT_EQ(found.set.header.response, parent.header.response);
    EXPECT_EQ(frf::names(found.measured), (std::vector<std::string>{"1:+X", "3:+X"}));
    EXPECT_TRUE(found.left_out.empty());
    for (std::size_t line = 0; line < 30; ++line) {
      EXPECT_LT(std::abs(found.set.values[found.set.index(line, 0, 2)] + truth.values[truth.index(line, 1, 0)]), 1e-9) << line;
      EXPECT_LT(std::abs(found.set.values[found.set.index(line, 2, 2)] - truth.values[truth.index(line, 0, 0)]), 1e-9) << line;
    }
    EXPECT_GT(found.parent_error, 0.1);
  }
}

TEST(CorrelatedSets, AGapOfTheParentIsAnError) {
  frf::FrfSet parent = drawn(dofs({"1:+X", "2:+X"}), 7);
  parent.values[5] = {std::nan(""), 0.0};
  EXPECT_THROW(expanded(parent, drawn(dofs({"1:+X"}), 8), Semm::extended), InputError);
}

TEST(CorrelatedSets, SerepExpandsResponses) {
  const std::vector<frf::Dof> all = dofs({"1:+X", "2:+X", "3:+X"});
  const ModeFile parent{"fe.uff", {mode(10.0, all, {1.0, 2.0, 3.0}), mode(20.0, all, {1.0, -1.0, 0.5})}};
  frf::FrfSet measured = drawn(dofs({"1:+X", "3:-X"}), 9);
  const ExpandedFrfs found = expanded(parent, measured, 0);
  EXPECT_EQ(found.set.header.reference, measured.header.reference);
  EXPECT_NEAR(found.parent_error, 0.0, 1e-12);  // two modes carry any motion of two coordinates
  for (std::size_t line = 0; line < 30; ++line) {
    const Complex x1 = measured.values[measured.index(line, 0, 0)], x3 = -measured.values[measured.index(line, 1, 0)];
    const Complex q2 = (3.0 * x1 - x3) / 2.5, q1 = x1 - q2;
    EXPECT_LT(std::abs(found.set.values[found.set.index(line, 1, 0)] - (2.0 * q1 - q2)), 1e-11) << line;
  }
  EXPECT_GT(expanded(parent, measured, 1).parent_error, 0.1);
}

}  // namespace
}  // namespace jointid::correlation
