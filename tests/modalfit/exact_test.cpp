#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "base/statistics.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"
#include "modalfit/poles/rational.hpp"

namespace jointid::modalfit {
namespace {

using testing::HasSubstr;

struct Structure {
  std::vector<double> frequency_hz, damping;
  std::vector<std::vector<double>> shape;  ///< [mode][coordinate]
};

/// Modes with shapes of random numbers.
Structure structure(std::vector<double> frequency_hz, std::vector<double> damping, std::size_t coordinates) {
  Structure out{std::move(frequency_hz), std::move(damping), {}};
  for (std::size_t r = 0; r < out.frequency_hz.size(); ++r) {
    out.shape.emplace_back();
    for (std::size_t i = 0; i < coordinates; ++i) out.shape.back().push_back(normal_numbers({.seed = 46}, 100 * r + i)[0]);
  }
  return out;
}

Structure six() { return structure({103.3, 158.7, 161.2, 254.0, 390.5, 611.0}, {0.01, 0.008, 0.012, 0.006, 0.005, 0.004}, 8); }

struct Measurement {
  std::size_t responses = 1, references = 1;
  double first_hz = 50.0, last_hz = 700.0, step_hz = 0.5;
  frf::Quantity quantity = frf::Quantity::receptance;
  Damping law = Damping::viscous;
};

/// Σ φ_a φ_b/(ω_r² − ω² + 2iζω_rω), or with iηω_r², as textbooks have it: no noise.
frf::FrfSet computed(const Structure& of, const Measurement& at) {
  frf::FrfSet set;
  set.header.file = "computed";
  set.header.quantity = at.quantity;
  for (std::size_t i = 0; i < at.responses; ++i) set.header.response.push_back(frf::Dof::parse(std::to_string(i + 1) + ":+Z"));
  for (std::size_t i = 0; i < at.references; ++i) set.header.reference.push_back(frf::Dof::parse(std::to_string(i + 1) + ":+Z"));
  for (double f = at.first_hz; f <= at.last_hz + 1e-9; f += at.step_hz) {
    set.header.frequency_hz.push_back(f);
    const double w = 2.0 * std::numbers::pi * f;
    for (std::size_t a = 0; a < at.responses; ++a) {
      for (std::size_t b = 0; b < at.references; ++b) {
        Complex h = 0.0;
        for (std::size_t r = 0; r < of.frequency_hz.size(); ++r) {
          const double wr = 2.0 * std::numbers::pi * of.frequency_hz[r], d = of.damping[r];
          h += of.shape[r][a] * of.shape[r][b] / Complex(wr * wr - w * w, at.law == Damping::viscous ? 2.0 * d * wr * w : d * wr * wr);
        }
        set.values.push_back(h);
      }
    }
  }
  return set;
}

ModalFit fit_of(const frf::FrfSet& set, const FitOptions& options = {}) {
  Band band = make_band(set, options.range_hz);
  return fit(band, set.header, options);
}

template <class Change>
frf::FrfSet changed(frf::FrfSet set, Change change) {
  for (Complex& value : set.values) value = change(value);
  return set;
}

std::vector<Pole> inside(const ModalFit& fit) {
  std::vector<Pole> out;
  for (const Mode& mode : fit.modes) {
    if (mode.inside) out.push_back(mode.pole);
  }
  return out;
}

void expect_exact(const ModalFit& found, const Structure& of, std::size_t first = 0, std::size_t beyond = 0) {
  ASSERT_EQ(found.status, Status::ok) << found.message;
  const std::vector<Pole> poles = inside(found);
  ASSERT_EQ(poles.size() + first + beyond, of.frequency_hz.size()) << testing::PrintToString(found.remarks);
  for (std::size_t r = 0; r < poles.size(); ++r) {
    EXPECT_NEAR(poles[r].frequency_hz / of.frequency_hz[first + r], 1.0, 1e-9) << r;
    EXPECT_NEAR(poles[r].damping / of.damping[first + r], 1.0, 1e-7) << r;
  }
}

TEST(Exact, OneModeInEveryQuantity) {
  const Structure one = structure({50.0}, {0.02}, 1);
  for (const auto quantity : {frf::Quantity::receptance, frf::Quantity::mobility, frf::Quantity::accelerance}) {
    expect_exact(fit_of(computed(one, {.first_hz = 1.0, .last_hz = 100.0, .step_hz = 1.0, .quantity = quantity})), one);
  }
}

TEST(Exact, SixModesInEveryShapeOfMatrix) {
  for (const auto& [responses, references] : {std::pair{1, 1}, {6, 1}, {1, 6}, {3, 3}}) {
    expect_exact(fit_of(computed(six(), {.responses = static_cast<std::size_t>(responses),
                                         .references = static_cast<std::size_t>(references), .step_hz = 1.0})),
                 six());
  }
}

TEST(Exact, EveryFamilyOfModels) {
  for (const Damping law : {Damping::viscous, Damping::hysteretic}) {
    for (const bool real : {true, false}) {
      const frf::FrfSet set = computed(six(), {.responses = 6, .references = 1, .step_hz = 2.0, .law = law});
      expect_exact(fit_of(set, {.kind = {law, real}}), six());
    }
  }
}

/// 0.15 of the half-power bandwidth apart.
TEST(Exact, TwoModesWithinABandwidthStayTwo) {
  const Structure close = structure({100.0, 100.3, 150.0}, {0.01, 0.012, 0.008}, 6);
  for (const std::size_t references : {1u, 3u}) {
    expect_exact(fit_of(computed(close, {.responses = 6, .references = references, .last_hz = 200.0})), close);
  }
}

/// Modes below and above the range, one of two near ones inside to be split.
TEST(Exact, ModesOutsideTheRangeAreFoundToo) {
  const ModalFit found = fit_of(computed(six(), {.responses = 8, .references = 2, .first_hz = 120.0, .last_hz = 500.0, .step_hz = 1.0}));
  expect_exact(found, six(), 1, 1);
}

/// Two and more modes beyond either end: more than two residual terms and a pole each follow.
TEST(Exact, PolesFarBeyondTheRangeAreAddedUntilTheFrfsAreFollowed) {
  const Structure many = structure({50.0, 120.0, 310.0, 420.0, 505.0, 700.0, 1200.0}, std::vector<double>(7, 0.01), 3);
  for (const Damping law : {Damping::viscous, Damping::hysteretic}) {
    const frf::FrfSet set =
        computed(many, {.responses = 3, .references = 3, .first_hz = 200.0, .last_hz = 600.0, .step_hz = 2.0, .law = law});
    const ModalFit found = fit_of(set, {.kind = {law, false}});
    expect_exact(found, many, 2, 2);
    EXPECT_LT(found.deviation, 1e-9);
  }
}

/// Thirteen modes close to both ends of the range: no search for one after the other finds them.
TEST(Exact, ThirteenModesBeyondTheRange) {
  std::vector<double> all;
  for (int k = 5; k >= 0; --k) all.push_back(85.0 * std::pow(0.8, k));
  all.insert(all.end(), {121.0, 143.0, 171.0});
  for (int k = 0; k < 7; ++k) all.push_back(220.0 * std::pow(1.17, k));
  const Structure many = structure(all, std::vector<double>(all.size(), 0.012), 4);
  for (const Damping law : {Damping::viscous, Damping::hysteretic}) {
    const frf::FrfSet set = computed(many, {.responses = 2, .references = 1,
                                            .first_hz = 100.0, .last_hz = 200.0, .step_hz = 0.5, .law = law});
    expect_exact(fit_of(set, {.kind = {law, false}}), many, 6, 7);
  }
}

TEST(Exact, RationalPolesAreThoseOfTheFrfsAndNoiseHasNone) {
  const frf::FrfSet exact = computed(six(), {.responses = 2, .references = 1, .step_hz = 2.0});
  const auto of = [](const frf::FrfSet& set) { return rational_poles(make_band(set, {}), {0, 1}, {Damping::viscous, false}); };
  const std::vector<Pole> poles = of(exact);
  ASSERT_EQ(poles.size(), 6U);
  for (std::size_t r = 0; r < 6; ++r) {
    EXPECT_NEAR(poles[r].frequency_hz / six().frequency_hz[r], 1.0, 1e-11);
    EXPECT_NEAR(poles[r].damping / six().damping[r], 1.0, 1e-9);
  }
  std::uint64_t count = 0;
  EXPECT_TRUE(of(changed(exact, [&](Complex h) { return h * (1.0 + 1e-9 * normal_numbers({.seed = 7}, count++)[0]); })).empty());
}

/// Weak in all FRFs and yet there.
TEST(Exact, AModeOfLessThanADecibelStays) {
  Structure weak = six();
  for (double& component : weak.shape[3]) component *= 0.1;
  expect_exact(fit_of(computed(weak, {.responses = 3, .step_hz = 1.0})), weak);
}

TEST(Exact, LightAndHeavyDamping) {
  const Structure light = structure({40.0, 112.0, 152.3}, {1e-4, 1e-4, 1.2e-4}, 3),
                  heavy = structure({40.0, 112.0, 230.0}, {0.1, 0.08, 0.05}, 3);
  expect_exact(fit_of(computed(light, {.responses = 3, .first_hz = 20.0, .last_hz = 180.0, .step_hz = 0.1})), light);
  expect_exact(fit_of(computed(heavy, {.responses = 3, .first_hz = 1.0, .last_hz = 300.0, .step_hz = 1.0})), heavy);
}

/// The digits of single precision are noise of their size.
TEST(Exact, DigitsOfSinglePrecisionAreTheFloor) {
  frf::FrfSet set = changed(computed(six(), {.responses = 6, .references = 2, .step_hz = 1.0}), [](Complex value) {
    return Complex(static_cast<float>(value.real()), static_cast<float>(value.imag()));
  });
  set.header.precision = 0x1p-24;
  const ModalFit found = fit_of(set);
  ASSERT_EQ(found.status, Status::ok) << found.message;
  ASSERT_EQ(found.modes_inside(), 6u);
  for (std::size_t r = 0; r < 6; ++r) EXPECT_NEAR(found.modes[r].pole.frequency_hz / six().frequency_hz[r], 1.0, 1e-8);
}

TEST(Exact, ALawOfDampingThatFitsBetterIsNamed) {
  const ModalFit found = fit_of(computed(six(), {.responses = 4, .references = 1, .step_hz = 1.0, .law = Damping::hysteretic}));
  EXPECT_THAT(found.remarks, testing::Contains(HasSubstr("--damping hysteretic")));
}

TEST(Size, PolesAndModelsAreThoseOfAnyPowerOfTwo) {
  const frf::FrfSet set = computed(six(), {.responses = 3, .references = 1, .step_hz = 2.0, .quantity = frf::Quantity::mobility});
  const ModalFit one = fit_of(set);
  ASSERT_EQ(one.modes_inside(), 6u);
  for (const int power : {-660, -31, 77, 660}) {
    const frf::FrfSet other = changed(set, [&](Complex value) { return value * std::ldexp(1.0, power); });
    Band band = make_band(other, {});
    const ModalFit found = fit(band, other.header, {});
    ASSERT_EQ(found.modes.size(), one.modes.size()) << power;
    for (std::size_t r = 0; r < one.modes.size(); ++r) {
      EXPECT_NEAR(found.modes[r].pole.frequency_hz / one.modes[r].pole.frequency_hz, 1.0, 1e-12) << power;
      EXPECT_NEAR(found.modes[r].pole.damping / one.modes[r].pole.damping, 1.0, 1e-10) << power;
    }
    const frf::FrfSet model = regenerate(make_symmetric(found, band), other.header);
    double worst = 0.0;
    for (std::size_t i = 0; i < model.values.size(); ++i) worst = std::max(worst, std::abs(model.values[i] / other.values[i] - 1.0));
    EXPECT_LT(worst, 1e-6) << power;
  }
}

/// One FRF of 1e-160 beside others that are measured counts as 0.
TEST(Size, AnFrfOfNextToNothingIsLeftOut) {
  frf::FrfSet set = computed(six(), {.responses = 3, .references = 2, .step_hz = 1.0});
  for (const double tiny : {1e-160, 1e-320, 0.0}) {
    for (std::size_t i = 0; i < set.header.lines(); ++i) set.values[set.index(i, 0, 0)] = {tiny, tiny};
    const ModalFit found = fit_of(set);
    expect_exact(found, six());
    EXPECT_EQ(found.residues.freedom[0], 0.0);
  }
}

TEST(Size, WhatIsNoNumberOfMetresIsRefused) {
  const frf::FrfSet set = computed(six(), {.step_hz = 1.0});
  for (const double factor : {1e-310, 0.0}) {
    EXPECT_THROW(fit_of(changed(set, [&](Complex value) { return value * factor; })), InputError) << factor;
  }
  EXPECT_THROW(fit_of(changed(set, [](Complex) { return Complex(nan, nan); })), InputError);
}

TEST(Looks, ConjugatedIsSaid) {
  const frf::FrfSet set = computed(six(), {.responses = 4, .references = 1, .step_hz = 1.0});
  const ModalFit found = fit_of(changed(set, [](Complex value) { return std::conj(value); }));
  EXPECT_FALSE(is_usable(found.status));
  EXPECT_THAT(found.message, HasSubstr("look conjugated"));
}

TEST(Looks, ForceOverMotionIsSaid) {
  const frf::FrfSet one = computed(structure({50.0}, {0.02}, 1), {.first_hz = 1.0, .last_hz = 100.0, .step_hz = 1.0});
  const ModalFit found = fit_of(changed(one, [](Complex value) { return 1.0 / value; }));
  EXPECT_FALSE(is_usable(found.status));
  EXPECT_THAT(found.message, HasSubstr("look inverted"));
}

TEST(Looks, RealFrfsAreNeverOk) {
  const frf::FrfSet set = computed(structure({50.0}, {0.02}, 1), {.first_hz = 1.0, .last_hz = 100.0, .step_hz = 1.0});
  const auto real = [](Complex value) { return Complex(value.real()); };
  const auto modulus = [](Complex value) { return Complex(std::abs(value)); };
  const auto decibel = [](Complex value) { return Complex(20.0 * std::log10(std::abs(value))); };
  for (const ModalFit& found : {fit_of(changed(set, real)), fit_of(changed(set, modulus)), fit_of(changed(set, decibel))}) {
    EXPECT_FALSE(is_usable(found.status)) << name(found.status);
    EXPECT_THAT(found.message, HasSubstr("real throughout"));
  }
  const ModalFit imaginary = fit_of(changed(set, [](Complex value) { return Complex(0.0, value.imag()); }));
  EXPECT_FALSE(is_usable(imaginary.status));
  EXPECT_THAT(imaginary.message, HasSubstr("imaginary throughout"));
}

/// Without damping frequencies are right, and damping is said not to be there.
TEST(Looks, AModelWithoutDampingIsDoubtful) {
  const Structure undamped = structure({7.08, 19.85, 28.68}, {0.0, 0.0, 0.0}, 3);
  const ModalFit found = fit_of(computed(undamped, {.responses = 3, .references = 3, .first_hz = 0.5, .last_hz = 50.0, .step_hz = 0.25}));
  EXPECT_EQ(found.status, Status::doubtful);
  EXPECT_THAT(found.message, HasSubstr("without damping"));
  ASSERT_EQ(found.modes_inside(), 3u);
  for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(inside(found)[r].frequency_hz / undamped.frequency_hz[r], 1.0, 1e-5);
}

/// Counted: what the model of N responses to one hammer point keeps grows with N, not with its square.
TEST(ManyResponses, TheModelKeepsNumbersInProportion) {
  const Structure few = structure({80.0, 123.0}, {0.01, 0.005}, 90);
  const frf::FrfSet set = computed(few, {.responses = 90, .first_hz = 60.0, .last_hz = 150.0, .step_hz = 1.0});
  Band band = make_band(set, {});
  const ModalFit found = fit(band, set.header, {});
  const SymmetricModel model = make_symmetric(found, band);
  ASSERT_EQ(model.modes.size(), 2u);
  EXPECT_EQ(model.residuals.size(), 90u);
  for (const SymmetricMode& mode : model.modes) EXPECT_EQ(mode.covariance.size(), 90u + 89u + 89u);
  const std::vector<double>& shape = few.shape[0];
  for (std::size_t i = 0; i < 90; ++i) {
    EXPECT_NEAR(model.modes[0].shape[i].real() / model.modes[0].shape[0].real(), shape[i] / shape[0], 1e-6 * std::abs(shape[i] / shape[0]));
  }
}

}  // namespace
}  // namespace jointid::modalfit
