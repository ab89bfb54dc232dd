#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/error.hpp"
#include "base/random.hpp"
#include "oscillation/delay/correlation.hpp"
#include "oscillation/delay/false_neighbours.hpp"
#include "oscillation/delay/mutual_information.hpp"
#include "oscillation/delay/neighbours.hpp"
#include "oscillation/delay/recurrence.hpp"
#include "oscillation/tangent/periodic_point.hpp"
#include "tests/oscillation/golden_series.hpp"
#include "tests/oscillation/models.hpp"
#include "tests/require.hpp"

namespace jointid::oscillation {
namespace {

std::vector<double> henon_record(std::size_t n) {
  Eigen::VectorXd z = Eigen::Vector2d(0.1, 0.1);
  Eigen::MatrixXd none(2, 0);
  const TangentStep step = henon(1.4, 0.3);
  std::vector<double> x;
  for (std::size_t i = 0; i < n + 100; ++i) {
    step(z, none);
    if (i >= 100) x.push_back(z(0));
  }
  return x;
}

/// The sequence of 2^order bits in which every word of `order` bits occurs once round the circle (Fredricksen & Maiorana 1978).
std::vector<int> de_bruijn(int order) {
  std::vector<int> a(static_cast<std::size_t>(order) + 1, 0), out;
  const auto grow = [&](auto&& self, int t, int p) -> void {
    if (t > order) {
      if (order % p == 0) out.insert(out.end(), a.begin() + 1, a.begin() + p + 1);
      return;
    }
    const auto place = static_cast<std::size_t>(t);
    a[place] = a[static_cast<std::size_t>(t - p)];
    self(self, t + 1, p);
    if (a[place] == 0) a[place] = 1, self(self, t + 1, t);
  };
  grow(grow, 1, 1);
  return out;
}

TEST(MutualInformation, OfTheDoublingMapIsExact) {
  OSCILLATION_CASE(golden, "shift_information");
  const std::vector<int> bits = de_bruijn(12);
  ASSERT_EQ(bits.size(), 4096u);
  std::vector<double> x;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    double value = 0.0;
    for (std::size_t j = 0; j < 12; ++j) value += bits[(i + j) % bits.size()] * std::pow(2.0, -static_cast<double>(j + 1));
    x.push_back(value);
  }
  const auto expected = golden["expected"]["bits"].get<std::vector<double>>();
  for (std::size_t lag = 0; lag < expected.size(); ++lag)
    EXPECT_NEAR(mutual_information(x, lag, {16, true}), expected[lag], 1e-12) << lag;
  for (const int k : {1, 2, 3, 5, 6}) {
    for (std::size_t lag = 0; lag < 7; ++lag) {
      EXPECT_NEAR(mutual_information(x, lag, {std::size_t{1} << k, true}), std::max(k - static_cast<double>(lag), 0.0), 1e-12);
    }
  }
}

TEST(MutualInformation, OfLorenzMeetsTheGoldenCurves) {
  OSCILLATION_CASE(golden, "series_lorenz");
  const auto x = golden["input"]["series"].get<std::vector<double>>();
  for (const auto& [cells, expected] : golden["expected"]["mutual_information_bits"].items()) {
    const InformationCurve curve = information_curve(x, 40, {std::stoul(cells), false});
    for (std::size_t lag = 0; lag <= 40; ++lag)
      EXPECT_NEAR(curve.bits[lag], expected[lag].get<double>(), 1e-10) << cells << " " << lag;
    EXPECT_EQ(curve.first_minimum, golden["expected"]["first_minimum"][cells].get<std::size_t>());
  }
}

TEST(MutualInformation, OfIndependentNumbersIsItsBias) {
  std::vector<double> x;
  for (std::uint64_t i = 0; i < 40000; ++i) x.push_back(uniform_numbers({7, 0, 0}, i)[0]);
  EXPECT_NEAR(mutual_information(x, 3, {16, false}), information_bias(16, x.size() - 3), 0.1 * information_bias(16, x.size()));
}

TEST(MutualInformation, OfAConstantIsNothing) {
  EXPECT_EQ(mutual_information(std::vector<double>(50, 3.0), 2), 0.0);
  EXPECT_THROW(mutual_information(std::vector<double>(5, 3.0), 5), InputError);
  EXPECT_THROW(mutual_information(std::vector<double>{1.0, std::nan(""), 2.0}, 1), InputError);
  EXPECT_FALSE(first_minimum(std::vector<double>{3.0, 2.0, 1.0}).has_value());
}

TEST(FalseNeighbours, OfLorenzMeetTheGoldenCounts) {
  OSCILLATION_CASE(golden, "series_lorenz");
  const auto& input = golden["input"];
  const auto x = input["series"].get<std::vector<double>>();
  const auto rows = false_neighbours(x, {input["delay"], 4, input["theiler"], input["rtol"], input["atol"]});
  ASSERT_EQ(rows.size(), 4u);
  for (const FalseNeighbours& row : rows) {
    const std::string d = std::to_string(row.dimension);
    const auto& expected = golden["expected"]["false_neighbours"][d];
    EXPECT_EQ(row.points, expected["points"].get<std::size_t>());
    EXPECT_NEAR(row.ratio, expected["ratio"], 1e-6) << d;
    EXPECT_NEAR(row.size, expected["size"], 1e-6) << d;
    EXPECT_NEAR(row.either, expected["either"], 1e-6) << d;
    EXPECT_NEAR(row.squared_ratio, golden["expected"]["false_neighbours_squared_print"][d], 1e-6) << d;
  }
}

TEST(FalseNeighbours, OfHenonVanishInTwoDimensionsOnlyByKennelsRatio) {
  const auto rows = false_neighbours(henon_record(6000), {1, 2, 0, 10.0, 2.0});
  EXPECT_EQ(rows[1].ratio, 0.0);
  EXPECT_NEAR(rows[1].squared_ratio, 0.025, 0.01);
  EXPECT_GT(rows[0].ratio, 0.5);
}

TEST(Neighbours, AreThoseOfASearchThroughAll) {
  RowMatrixXd points(400, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      points(i, k) =
          std::round(20.0 * uniform_numbers({3, 0, 0}, static_cast<std::uint64_t>(3 * i + k))[0]);  // with ties and repetitions
    }
  }
  const Neighbours tree(points, 7);
  for (std::size_t i = 0; i < 400; ++i) {
    std::size_t best = 400;
    std::vector<std::size_t> close, found;
    for (std::size_t j = 0; j < 390; ++j) {
      const double d = (points.row(at(i)) - points.row(at(j))).norm();
      if ((i > j ? i - j : j - i) <= 7) continue;
      if (d <= 4.0) close.push_back(j);
      if (d > 0.0 && (best == 400 || d < (points.row(at(i)) - points.row(at(best))).norm())) best = j;
    }
    const auto near = tree.nearest(i, 390);
    ASSERT_TRUE(near);
    EXPECT_EQ(near->index, best);
    tree.within(i, 4.0, [&](std::size_t j) {
      if (j < 390) found.push_back(j);
    });
    std::ranges::sort(found);
    EXPECT_EQ(found, close);
  }
}

TEST(Correlation, OfLorenzMeetsTheGoldenSums) {
  OSCILLATION_CASE(golden, "series_lorenz");
  const auto& input = golden["input"];
  const auto x = input["series"].get<std::vector<double>>();
  const auto radii = input["radii"].get<std::vector<double>>();
  const auto sums = correlation_sum(delay_points(x, {3, input["delay"]}), input["theiler"], radii);
  for (std::size_t k = 0; k < radii.size(); ++k) EXPECT_NEAR(sums[k], golden["expected"]["correlation_sum"][k], 1e-9);
}

TEST(Correlation, DimensionOfHenonAndOfNoise) {
  const auto found = correlation_dimension(henon_record(4000), {2, 1}, 0);
  ASSERT_TRUE(found.dimension);
  EXPECT_NEAR(found.dimension->slope, 1.21, 0.06);
  std::vector<double> circle;
  for (int i = 0; i < 2000; ++i) circle.push_back(std::sin(0.6180339887 * i));
  const auto line = correlation_dimension(circle, {2, 2}, 0);
  ASSERT_TRUE(line.dimension);
  EXPECT_NEAR(line.dimension->slope, 1.0, 0.1);
}

TEST(Recurrence, FindsThePeriodOfACircle) {
  std::vector<double> x;
  for (int i = 0; i < 500; ++i) x.push_back(std::sin(2.0 * std::numbers::pi * i / 50.3));
  const RowMatrixXd points = delay_points(x, {2, 12});
  const auto found = recurrences(points, half_mean_step(points));
  ASSERT_FALSE(found.empty());
  const auto periods = recurrent_periods(found, 2);
  EXPECT_NEAR(static_cast<double>(periods.front().best.period), 50.3, 1.0);
  EXPECT_GT(periods.front().count, 300u);
}

TEST(Recurrence, OfHenonLeadsToItsUnstableOrbits) {
  const auto x = henon_record(4000);
  const RowMatrixXd points = delay_points(x, {2, 1});
  const auto found = recurrences(points, 0.05);
  bool two = false;
  for (const Recurrence& each : found) {
    if (each.period != 2) continue;
    Eigen::VectorXd start = Eigen::Vector2d(points(at(each.start), 1), 0.3 * points(at(each.start), 0));
    const PeriodicPoint orbit = periodic_point(henon(1.4, 0.3), start, 2);
    two = two || (orbit.converged && std::abs(orbit.state(0) - 0.97580005117505625) < 1e-10);
  }
  EXPECT_TRUE(two);
}

}  // namespace
}  // namespace jointid::oscillation
