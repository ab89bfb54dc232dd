#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "base/random.hpp"
#include "oscillation/delay/divergence.hpp"
#include "oscillation/delay/wolf.hpp"
#include "oscillation/tangent/periodic_point.hpp"
#include "tests/oscillation/golden_series.hpp"
#include "tests/oscillation/models.hpp"
#include "tests/require.hpp"

namespace jointid::oscillation {
namespace {

TEST(Spectrum, OfHenonMeetsTheGoldenExponents) {
  OSCILLATION_CASE(golden, "henon");
  const auto& expected = golden["expected"];
  const double a = golden["input"]["a"], b = golden["input"]["b"];
  const Spectrum found = lyapunov_spectrum(henon(a, b), Eigen::Vector2d(0.1, 0.1), {2, 1000, 200000, 20, 1.0});
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_TRUE(agree(found.exponent[e], found.standard_error[e], expected["exponents_nats"][e], expected["std_error"][e], 0.0))
        << found.exponent[e];
  }
  EXPECT_NEAR(found.exponent[0] + found.exponent[1], expected["sum_exact"], 1e-10);
}

TEST(PeriodicPoint, OfHenonMeetsTheGoldenPoints) {
  OSCILLATION_CASE(golden, "henon");
  const auto& expected = golden["expected"];
  const TangentStep step = henon(golden["input"]["a"], golden["input"]["b"]);
  const PeriodicPoint fixed = periodic_point(step, Eigen::Vector2d(0.6, 0.2));
  ASSERT_TRUE(fixed.converged);
  EXPECT_NEAR(fixed.state(0), expected["fixed_point_x"], 1e-10);
  for (std::size_t e = 0; e < 2; ++e) EXPECT_NEAR(fixed.multipliers[e].real(), expected["fixed_point_multipliers"][e], 1e-10);
  const PeriodicPoint two = periodic_point(step, Eigen::Vector2d(-0.5, 0.3), 2);
  ASSERT_TRUE(two.converged);
  EXPECT_NEAR(two.state(0), expected["period2_x"][0], 1e-10);
  const PeriodicPoint other = periodic_point(step, Eigen::Vector2d(1.0, -0.1), 2);
  ASSERT_TRUE(other.converged);
  EXPECT_NEAR(other.state(0), expected["period2_x"][1], 1e-10);
}

TEST(Spectrum, OfLorenzMeetsTheGoldenExponents) {
  OSCILLATION_CASE(golden, "lorenz");
  const auto& expected = golden["expected"];
  const Lorenz lorenz{golden["input"]["sigma"], golden["input"]["rho"], golden["input"]["beta"]};
  const double time = 0.02;
  const Spectrum found = lyapunov_spectrum(lorenz.step(time), Eigen::Vector3d(1.0, 1.0, 20.0), {3, 2000, 40000, 20, time});
  double sum = 0.0;
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_TRUE(agree(found.exponent[e], found.standard_error[e], expected["exponents_nats"][e], expected["std_error"][e], 0.0))
        << found.exponent[e] << " ± " << found.standard_error[e];
    sum += found.exponent[e];
  }
  EXPECT_NEAR(sum, expected["sum_exact"], 1e-6);
}

TEST(Spectrum, OfAStepWithoutInverseEndsAtMinusInfinity) {
  const TangentStep step = [](Eigen::VectorXd& z, Eigen::MatrixXd& w) {
    z(0) *= 0.5;
    w.row(0) *= 0.5;
    w.row(1).setZero();
  };
  const Spectrum found = lyapunov_spectrum(step, Eigen::Vector2d(1.0, 1.0), {2, 1, 40, 4, 1.0});
  EXPECT_NEAR(found.exponent[0], -std::numbers::ln2, 1e-12);
  EXPECT_EQ(found.exponent[1], -std::numeric_limits<double>::infinity());
}

std::vector<double> lorenz_record(std::size_t n, double dt) {
  Eigen::VectorXd z = Eigen::Vector3d(1.0, 1.0, 20.0);
  Eigen::MatrixXd none(3, 0);
  std::vector<double> x;
  for (std::size_t i = 0; i < n + 500; ++i) {
    Lorenz().advance(z, none, dt);
    if (i >= 500) x.push_back(z(0));
  }
  return x;
}

TEST(RecordExponent, OfLorenzLiesOnAPlateau) {
  const auto x = lorenz_record(6000, 0.03);
  const DivergenceOptions options{{4, 4}, 40, 100, 0.03};
  const RecordExponent found = largest_exponent_rosenstein(x, options);
  ASSERT_TRUE(found.nats_per_second) << found.reason;
  EXPECT_NEAR(*found.nats_per_second, 0.906, 0.12);
  const RecordExponent kantz = largest_exponent_kantz(x, options);
  ASSERT_TRUE(kantz.nats_per_second) << kantz.reason;
  EXPECT_NEAR(*kantz.nats_per_second, 0.906, 0.15);
}

TEST(RecordExponent, OfNoiseAndOfAPeriodicRecordIsNotDetermined) {
  std::vector<double> noise, sine;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    noise.push_back(normal_numbers({5, 0, 0}, i)[0]);
    sine.push_back(std::sin(0.1 * static_cast<double>(i)) + 0.5 * std::sin(0.1 * std::numbers::sqrt2 * static_cast<double>(i)));
  }
  for (const auto& record : {noise, sine}) {
    const RecordExponent found = largest_exponent_rosenstein(record, {{3, 5}, 50, 60, 1.0});
    EXPECT_FALSE(found.nats_per_second);
    EXPECT_FALSE(found.reason.empty());
  }
}

TEST(Plateau, NeedsAStraightStretchThatRises) {
  std::vector<double> x, line, bent, flat;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i;
    x.push_back(t);
    line.push_back(t < 3.0 ? 2.0 * t : 6.0);
    bent.push_back(3.0 * std::sqrt(t));
    flat.push_back(1e-3 * t);
  }
  const auto found = find_plateau(x, line);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->slope, 2.0, 0.1);
  EXPECT_LE(x[found->last], 3.5);
  PlateauOptions strict;
  strict.least_rise = 3.0;
  EXPECT_FALSE(find_plateau(x, bent, strict));
  EXPECT_FALSE(find_plateau(x, flat));
  EXPECT_THROW(find_plateau(x, std::vector<double>(3, 0.0)), InputError);
}

/// Of another program, by the same rules; the series is that of oscillations.json.
TEST(Wolf, OfLorenzMeetsTheGoldenNumbers) {
  OSCILLATION_CASE(golden, "series_lorenz");
  const nlohmann::json seeds = golden_file("seeds.json").at("cases");
  const auto& wolf = *std::ranges::find(seeds, "wolf_on_series_lorenz", [](const auto& each) { return each["name"]; });
  const auto& input = wolf["input"];
  auto x = golden["input"]["series"].get<std::vector<double>>();
  x.resize(input["samples"]);
  for (const auto& [evolve, expected] : wolf["expected"].items()) {
    const WolfExponent found = wolf_exponent(x, {.embedding = {input["d"], input["T"]},
                                                 .theiler = input["theiler"],
                                                 .evolve = std::stoul(evolve),
                                                 .smallest = input["smin"],
                                                 .largest = input["smax"],
                                                 .sample_time = input["dt"]});
    EXPECT_NEAR(found.bits_per_second, expected.get<double>(), 1e-9) << evolve;
    EXPECT_GE(found.pairs, found.replaced);
  }
}

/// Its exponent is one bit a step: x' = 4x(1 − x) is the tent map, whose slope is 2.
TEST(Wolf, OfTheLogisticMapIsOneBitAStep) {
  std::vector<double> x = {0.2345};
  while (x.size() < 4000) x.push_back(4.0 * x.back() * (1.0 - x.back()));
  for (const std::size_t evolve : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    const WolfExponent found =
        wolf_exponent(x, {.embedding = {1, 1}, .theiler = 5, .evolve = evolve, .smallest = 1e-6, .largest = 0.02});
    EXPECT_NEAR(found.bits_per_second, 1.0, 0.04) << evolve;
    EXPECT_GT(found.replaced, found.pairs / 2);
  }
}

/// Neighbours of a quasi-periodic record stay neighbours.
TEST(Wolf, OfTwoTonesIsNothing) {
  std::vector<double> x;
  for (int i = 0; i < 4000; ++i) x.push_back(std::sin(0.1 * i) + 0.5 * std::sin(0.1618 * i));
  const WolfExponent found = wolf_exponent(x, {.embedding = {4, 12}, .theiler = 100, .evolve = 20, .smallest = 1e-3, .largest = 0.3});
  EXPECT_NEAR(found.bits_per_second * 20.0, 0.0, 0.05);
}

TEST(Wolf, RefusesWhatMakesNoPairs) {
  const std::vector<double> x(50, 1.0);
  const WolfOptions right{.embedding = {1, 1}, .largest = 1.0};
  EXPECT_TRUE(std::isnan(wolf_exponent(x, right).bits_per_second));  // equal points are no pair
  for (const auto& change : std::vector<std::function<void(WolfOptions&)>>{
           [](WolfOptions& o) { o.evolve = 0; }, [](WolfOptions& o) { o.largest = 0.0; }, [](WolfOptions& o) { o.smallest = -1.0; },
           [](WolfOptions& o) { o.sample_time = 0.0; }, [](WolfOptions& o) { o.evolve = 30; }}) {
    WolfOptions wrong = right;
    change(wrong);
    EXPECT_THROW(wolf_exponent(x, wrong), InputError);
  }
}

}  // namespace
}  // namespace jointid::oscillation
