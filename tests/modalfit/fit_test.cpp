#include "modalfit/model/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "base/control.hpp"
#include "base/error.hpp"
#include "modalfit/poles/clusters.hpp"
#include "modalfit/poles/selection.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

constexpr ModelKind hysteretic_real{Damping::hysteretic, true};

ModalFit fitted(const frf::FrfSet& set, FitOptions options) {
  Band band = make_band(set, options.range_hz);
  return fit(band, set.header, options);
}

frf::FrfSet pair_with_noise() { return problems::polluted(problems::make_modal_set("modes-pair"), 1, 0); }

TEST(Fit, FindsTheClosePairInEveryFamilyOfModels) {
  const frf::FrfSet set = pair_with_noise();
  for (const ModelKind& kind : {hysteretic_real, ModelKind{Damping::hysteretic, false}, ModelKind{Damping::viscous, true}, ModelKind{}}) {
    const ModalFit found = fitted(set, {.kind = kind});
    ASSERT_EQ(found.status, Status::ok) << found.message;
    ASSERT_EQ(found.modes.size(), 2u);
    const double damping = kind.damping == Damping::hysteretic ? 0.002 : 0.001;
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_NEAR(found.modes[r].pole.frequency_hz, 100.0 + static_cast<double>(r), 1e-4);
      EXPECT_NEAR(found.modes[r].pole.damping, damping, 0.005 * damping);
      EXPECT_GT(found.modes[r].significance, 10.0);
    }
  }
}

TEST(Fit, EstimatesTheNoiseThatNobodyTold) {
  frf::FrfSet set = pair_with_noise();
  set.variance.clear();
  set.header.noise = frf::NoiseRecord::none;
  Band band = make_band(set, {});
  const ModalFit found = fit(band, set.header, {.kind = hysteretic_real});
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_FALSE(found.known_noise);
  EXPECT_NEAR(found.cost / found.freedom, 1.0, 0.02);
  double sum = 0.0;  // σ/|H| is 0.01/√2
  for (std::size_t i = 0; i < band.lines(); ++i) sum += 1.0 / (band.weights(3)[2 * i] * std::abs(band.value(3)[i]));
  EXPECT_NEAR(sum / static_cast<double>(band.lines()), 0.01 / std::sqrt(2.0), 0.0005);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_NEAR(found.modes[r].pole.frequency_hz, 100.0 + static_cast<double>(r), 5.0 * found.modes[r].frequency_deviation_hz);
  }
}

TEST(Fit, KeepsTheMostSignificantWhenToldHowMany) {
  const ModalFit found = fitted(pair_with_noise(), {.kind = hysteretic_real, .modes = 1});
  EXPECT_EQ(found.modes_inside(), 1u);
}

TEST(Fit, SaysSoWhereThereIsNoMode) {
  const ModalFit found = fitted(pair_with_noise(), {.kind = hysteretic_real, .range_hz = std::array{104.0, 110.0}});
  EXPECT_EQ(found.status, Status::no_modes);
  EXPECT_TRUE(found.modes.empty());
  EXPECT_NE(found.message, "");
}

TEST(Fit, WorksWithMoreReferencesThanResponsesAlike) {
  frf::FrfSet set = problems::polluted(problems::make_modal_set("modes-pair"), 2, 0);
  frf::FrfSet turned = set;
  std::swap(turned.header.response, turned.header.reference);
  for (std::size_t i = 0; i < set.header.lines(); ++i) {
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 2; ++c) {
        turned.values[turned.index(i, c, r)] = set.values[set.index(i, r, c)];
        turned.variance[turned.index(i, c, r)] = set.variance[set.index(i, r, c)];
      }
    }
  }
  const ModalFit one = fitted(set, {.kind = hysteretic_real}), other = fitted(turned, {.kind = hysteretic_real});
  ASSERT_EQ(one.modes.size(), 2u);
  ASSERT_EQ(other.modes.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_NEAR(one.modes[r].pole.frequency_hz, other.modes[r].pole.frequency_hz, 1e-2 * one.modes[r].frequency_deviation_hz);
  }
}

TEST(Fit, PassesOverWhatWasNotMeasured) {
  frf::FrfSet set = pair_with_noise();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < set.header.lines(); ++i) {
    set.values[set.index(i, 2, 1)] = {nan, nan};
    if (i % 7 == 0) set.values[set.index(i, 0, 0)] = {nan, nan};
  }
  const ModalFit found = fitted(set, {.kind = hysteretic_real});
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_EQ(found.residues.freedom[5], 0.0);
  EXPECT_GT(found.residues.freedom[0], 0.0);
  EXPECT_LT(found.residues.freedom[0], found.residues.freedom[1]);
}

/// A fit that nobody waits for ends between two FRFs, wherever it is.
TEST(Fit, EndsWhereItIsAbandoned) {
  const frf::FrfSet set = pair_with_noise();
  std::atomic<int> looks = 0;
  const auto looks_of = [&](int most) {
    looks = 0;
    Band band = make_band(set, std::nullopt);
    band.watch = [&looks, most] {
      if (++looks > most) throw Interrupted();
    };
    fit(band, set.header, {});
    return looks.load();
  };
  const int all = looks_of(std::numeric_limits<int>::max());
  EXPECT_GT(all, 50);
  for (const int most : {0, all / 4, all / 2, all - 1}) EXPECT_THROW(looks_of(most), Interrupted) << most;
}

/// A unit change of the FRFs scales residues and leaves poles alone.
TEST(Fit, PolesDoNotDependOnTheUnit) {
  const FitOptions options{.kind = hysteretic_real, .range_hz = std::array{98.0, 103.0}};
  const frf::FrfSet set = pair_with_noise();
  const ModalFit one = fitted(set, options);
  for (const double factor : {1e-12, 3e9}) {
    frf::FrfSet scaled = set;
    for (auto& value : scaled.values) value *= factor;
    for (auto& value : scaled.variance) value *= factor * factor;
    const ModalFit other = fitted(scaled, options);
    ASSERT_EQ(one.modes.size(), other.modes.size());
    for (std::size_t r = 0; r < one.modes.size(); ++r) {
      EXPECT_NEAR(one.modes[r].pole.frequency_hz / other.modes[r].pole.frequency_hz, 1.0, 1e-9);
    }
  }
}

TEST(Band, RefusesRangesWithTooFewLinesAndLeavesOutZeroHertz) {
  frf::FrfSet set = pair_with_noise();
  try {
    make_band(set, std::array{100.0, 100.1});
    FAIL() << "a range of 6 lines was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("6 lines are in it"));
  }
  set.header.frequency_hz[0] = 0.0;
  EXPECT_EQ(make_band(set, {}).lines(), set.header.lines() - 1);
}

TEST(ChiSquare, QuantilesAreThoseOfTables) {
  EXPECT_NEAR(chi_square_quantile(10.0, 1.6448536), 18.307, 0.02);
  EXPECT_NEAR(chi_square_quantile(100.0, 2.3263479), 135.807, 0.05);
}

TEST(Clusters, FollowAPoleFromOrderToOrderAndLeaveOutStrays) {
  std::vector<OrderPoles> orders;
  for (std::size_t n = 1; n <= 12; ++n) {
    const double drift = 0.01 * static_cast<double>(n);
    OrderPoles order{n, {{100.0 + drift, 0.01, 0.1 / static_cast<double>(n)}}};
    order.poles.push_back({37.0 * static_cast<double>(n), 0.002, 0.01});          // a stray, elsewhere each time
    order.poles.push_back({150.0, -0.01, 0.01});                                  // unstable
    if (n > 6) order.poles.push_back({200.0, 0.02, 0.1});                         // from order 7 on
    orders.push_back(order);
  }
  const auto found = cluster(orders, {});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].hits, 12u);
  EXPECT_NEAR(found[0].pole.frequency_hz, 100.12, 1e-12);  // the smallest deviation is that of the last order
  EXPECT_EQ(found[1].hits, 6u);
}

}  // namespace
}  // namespace jointid::modalfit
