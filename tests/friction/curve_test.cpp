#include "friction/curve/curve.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "friction/fit/fit_start.hpp"
#include "friction/fit/tied_limit.hpp"
#include "friction/law/laws.hpp"

namespace jointid::friction {
namespace {

struct Case {
  const char* law;
  std::vector<double> values;
};

const Case cases[] = {{"ren", {3.43e-8, 2.79, 5.7e8}},
                      {"shoukry", {114.0, 5.5e6}},
                      {"burdekin", {5.5e8, -7.9e14}},
                      {"bilinear", {2.13e-7, 5.5e8}}};

/// All kinds of curves of an element, to 6e-7 m, exact.
std::vector<Curve> curves_of(const Element& element) {
  Curve loading, loop, energy, equivalent;
  const double most = 6e-7;
  for (int i = -5; i <= 40; ++i) loading.u.push_back(most * i / 40.0);
  for (int i = 0; i <= 80; ++i) loop.u.push_back(most * (1.0 - std::abs(i - 40.0) / 20.0));
  for (double& u : loop.u) u = std::max(u, -most);
  for (int i = 1; i <= 6; ++i) energy.u.push_back(most * i / 6.0);
  equivalent.u = energy.u;
  loop.turn = 40;
  loop.kind = CurveKind::loop;
  energy.kind = CurveKind::energy;
  equivalent.kind = CurveKind::equivalent;
  std::vector<Curve> all = {loading, loop, energy, equivalent};
  for (Curve& curve : all) {
    curve.value.assign(curve.u.size(), 0.0);
    if (curve.kind == CurveKind::equivalent) curve.damping = curve.value;
    const std::vector<double> exact = predicted(element, curve);
    for (std::size_t row = 0; row < exact.size(); ++row) {
      (row < curve.value.size() ? curve.value[row] : curve.damping[row - curve.value.size()]) = exact[row];
    }
  }
  return all;
}

TEST(Curve, LoopsCloseAndHoldTheEnergyOfTheCycle) {
  for (const Case& each : cases) {
    const auto element = make_element(each.law, each.values);
    const Curve loop = curves_of(*element)[1];
    EXPECT_NEAR(loop.value.front(), -element->response(6e-7).force, 1e-12 * loop.value[40]);
    EXPECT_NEAR(loop.value.back(), loop.value.front(), 1e-12 * loop.value[40]);
    EXPECT_NEAR(loop.value[40], element->response(6e-7).force, 1e-12 * loop.value[40]);
    EXPECT_NEAR((Loop{{loop.u, loop.value}, loop.turn}).energy(), element->cycle_energy(6e-7), 2e-3 * element->cycle_energy(6e-7))
        << each.law;
  }
}

TEST(Curve, DerivativesAreThoseOfDifferences) {
  for (const Case& each : cases) {
    const auto element = make_element(each.law, each.values);
    for (const Curve& curve : curves_of(*element)) {
      const std::vector<double> exact = predicted_derivative(*element, curve);
      const std::size_t parameters = each.values.size();
      for (std::size_t i = 0; i < parameters; ++i) {
        const double step = 1e-6 * std::abs(each.values[i]);
        std::vector<double> above = each.values, below = each.values;
        above[i] += step;
        below[i] -= step;
        const std::vector<double> high = predicted(*element->with(above), curve), low = predicted(*element->with(below), curve);
        for (std::size_t row = 0; row < curve.rows(); ++row) {
          const double difference = (high[row] - low[row]) / (2.0 * step);
          const double scale = std::abs(curve.measured(curve.value.size() - 1) / each.values[i]);
          EXPECT_NEAR(exact[row * parameters + i], difference, 2e-6 * scale)
              << each.law << " kind " << static_cast<int>(curve.kind) << " row " << row << " parameter " << i;
        }
      }
    }
  }
}

TEST(Curve, FeaturesOfEveryKindAreRoughlyTheElements) {
  for (const Case& each : cases) {
    const auto element = make_element(each.law, each.values);
    for (const Curve& curve : curves_of(*element)) {
      const Features seen = features(curve);
      EXPECT_NEAR(std::log(seen.limit / element->limit()), 0.0, 0.9) << each.law << " kind " << static_cast<int>(curve.kind);
      EXPECT_NEAR(std::log(seen.stiffness / element->response(0.0).tangent), 0.0, 1.8)
          << each.law << " kind " << static_cast<int>(curve.kind);
    }
  }
}

TEST(Curve, WhatCannotBeFittedIsRefusedByName) {
  const auto refusal = [](const Curve& curve) -> std::string {
    try {
      validate(curve);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Curve good = loading_curve("rig", {{0.0, 1.0}, {0.0, 2.0}});
  EXPECT_EQ(refusal(good), "");
  EXPECT_EQ(refusal(loading_curve("rig", {})), "rig: there are no samples; correct the curve, or leave it out");
  EXPECT_THAT(refusal(loading_curve("rig", {{1.0}, {1.0, 2.0}})), testing::HasSubstr("not equally many"));
  EXPECT_THAT(refusal(loading_curve("rig", {{1.0}, {NAN}})), testing::HasSubstr("not finite"));
  EXPECT_THAT(refusal(loading_curve("rig", {{1.0}, {0.0}})), testing::HasSubstr("all values are zero"));
  EXPECT_THAT(refusal(loading_curve("rig", {{0.0}, {1.0}})), testing::HasSubstr("no displacement"));
  good.normal_load = -1.0;
  EXPECT_THAT(refusal(good), testing::HasSubstr("normal load"));
  Curve series = good;
  series.normal_load.reset();
  series.kind = CurveKind::energy;
  EXPECT_THAT(refusal(series), testing::HasSubstr("amplitude is not positive"));
  series.kind = CurveKind::equivalent;
  EXPECT_THAT(refusal(series), testing::HasSubstr("not equally many"));
  series.kind = CurveKind::loop;
  EXPECT_THAT(refusal(series), testing::HasSubstr("no two branches"));
}

TEST(TiedLimit, AnElementIsMovedToAPresetLimitByOneParameter) {
  for (const Case& each : cases) {
    const auto element = make_element(each.law, each.values);
    const auto tied = tied_parameter(*element, std::vector<bool>(each.values.size(), false));
    ASSERT_TRUE(tied) << each.law;
    const auto moved = with_limit(*element, *tied, 3.0 * element->limit());
    ASSERT_NE(moved, nullptr) << each.law;
    EXPECT_NEAR(moved->limit(), 3.0 * element->limit(), 1e-11 * moved->limit()) << each.law;
    for (std::size_t i = 0; i < each.values.size(); ++i) EXPECT_EQ(moved->values()[i] == each.values[i], i != *tied);
  }
  EXPECT_FALSE(tied_parameter(*make_element("spring", std::vector{1.0}), {false}));
}

TEST(TiedLimit, TheDerivativeOfTheLimitIsThatOfDifferences) {
  for (const Case& each : cases) {
    const auto element = make_element(each.law, each.values);
    const std::vector<double> exact = limit_derivative(*element);
    for (std::size_t i = 0; i < each.values.size(); ++i) {
      std::vector<double> above = each.values, below = each.values;
      above[i] *= 1.0 + 1e-6;
      below[i] *= 1.0 - 1e-6;
      const double difference = (element->with(above)->limit() - element->with(below)->limit()) / (2e-6 * each.values[i]);
      EXPECT_NEAR(exact[i], difference, 1e-7 * element->limit() / std::abs(each.values[i])) << each.law << i;
    }
  }
}

}  // namespace
}  // namespace jointid::friction
