#include "study/order_statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>
#include <random>

namespace jointid::study {
namespace {

ColumnPass in_pieces(const std::vector<double>& column, std::size_t piece) {
  return [&column, piece](const PieceVisitor& visit) {
    for (std::size_t first = 0; first < column.size(); first += piece) {
      visit(std::span(column).subspan(first, std::min(piece, column.size() - first)));
    }
  };
}

/// Without NaN, −0 before +0.
std::vector<double> sorted(std::vector<double> column) {
  std::erase_if(column, [](double x) { return std::isnan(x); });
  std::ranges::sort(column, [](double a, double b) { return std::is_lt(std::strong_order(a, b)); });
  return column;
}

std::vector<std::uint64_t> bits_of(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> bits;
  for (const double x : numbers) bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

void expect_sorting(const std::vector<double>& column, std::size_t most_kept) {
  const std::vector<double> expected = sorted(column);
  const ColumnPass pass = in_pieces(column, 7);
  ASSERT_EQ(count_numbers(pass), expected.size());
  std::vector<std::size_t> places(expected.size());
  std::iota(places.rbegin(), places.rend(), std::size_t{0});
  std::vector<double> found = order_statistics(pass, places, most_kept);
  std::ranges::reverse(found);
  EXPECT_EQ(bits_of(found), bits_of(expected));
}

using Limits = std::numeric_limits<double>;
const std::vector<double> special = {0.0, -0.0, Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
                                     Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min(), -Limits::denorm_min(),
                                     1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0), -1.0};

RC_GTEST_PROP(OrderStatistics, AreThoseOfSorting, ()) {
  const auto numbers = rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::elementOf(special));
  const auto column = *rc::gen::container<std::vector<double>>(numbers);
  const auto most_kept = *rc::gen::inRange<std::size_t>(0, 20);
  expect_sorting(column, most_kept);
}

TEST(OrderStatistics, OfTiesTakeEveryBit) {
  std::vector<double> column(1000, -3.25);
  column.insert(column.end(), 1000, std::nextafter(-3.25, 0.0));
  column.insert(column.end(), 10, -0.0);
  column.insert(column.end(), 10, 0.0);
  expect_sorting(column, 0);
  expect_sorting(column, 500);
}

TEST(OrderStatistics, TakeFewPassesOverNoisyNumbers) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal(1e6, 2e5);
  std::vector<double> column(200'000);
  for (double& x : column) x = normal(generator);
  const ColumnPass once = in_pieces(column, 4096);
  int passes = 0;
  const ColumnPass counted = [&](const PieceVisitor& visit) {
    ++passes;
    once(visit);
  };
  const std::vector<std::size_t> places = {10'000, 10'001, 100'000, 190'000};
  const std::vector<double> found = order_statistics(counted, places, 10'000);
  const std::vector<double> expected = sorted(column);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(found[i], expected[places[i]]);
  EXPECT_LE(passes, 4);
}

}  // namespace
}  // namespace jointid::study
