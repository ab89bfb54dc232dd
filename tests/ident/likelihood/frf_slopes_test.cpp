#include "ident/likelihood/data/frf_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace jointid::ident {
namespace {

constexpr std::size_t coordinates = 3;
const Complex first_pole(101.3, 0.8), second_pole(104.1, 1.1);

/// Residue of an FRF at a pole: other ones for each.
Complex residue(std::size_t row, std::size_t column, double of) {
  const auto place = static_cast<double>(row * (row + 1) / 2 + column);
  return {std::cos(of * place + 1.0), std::sin(2.0 * of * place)};
}

/// Two resonances and the rest of the others.
Complex frf(double f, std::size_t row, std::size_t column) {
  return residue(row, column, 1.0) / (f - first_pole) + residue(row, column, 2.3) / (f - second_pole) + residue(row, column, 0.4);
}

Complex derivative(double f, std::size_t row, std::size_t column) {
  const Complex one = f - first_pole, two = f - second_pole;
  return -residue(row, column, 1.0) / (one * one) - residue(row, column, 2.3) / (two * two);
}

MeasuredFrfs line_at(double f, double deviation) {
  MeasuredFrfs out(coordinates);
  for (std::size_t r = 0; r < coordinates; ++r) {
    for (std::size_t c = 0; c <= r; ++c) out.at(r, c) = {frf(f, r, c), Complex(1.0, 1.0) * deviation * deviation};
  }
  return out;
}

/// Of every FRF at the line `own`, over the derivative.
double largest_error(const std::vector<double>& frequency, std::size_t own, double deviation) {
  std::vector<MeasuredFrfs> lines;
  for (const double f : frequency) lines.push_back(line_at(f, deviation));
  std::vector<const MeasuredFrfs*> all;
  for (const MeasuredFrfs& line : lines) all.push_back(&line);
  const FrfSlopes slopes({0, 1, 2}, frequency, all, own);
  double largest = 0.0;
  for (std::size_t r = 0; r < coordinates; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      const Complex expected = derivative(frequency[own], r, c);
      largest = std::max(largest, std::abs(slopes.of({r, c}) - expected) / std::abs(expected));
      EXPECT_EQ(slopes.of({c, r}), slopes.of({r, c}));
    }
  }
  return largest;
}

TEST(FrfSlopes, AreExactOfTwoResonancesFromFiveLinesWiderApartThanTheseAre) {
  const std::vector<double> frequency = {97.0, 99.5, 102.0, 105.0, 107.5};
  for (const std::size_t own : {std::size_t{0}, std::size_t{2}, std::size_t{4}}) EXPECT_LT(largest_error(frequency, own, 1e-9), 1e-6) << own;
}

TEST(FrfSlopes, OfThreeLinesTakeOneResonance) {
  const std::vector<double> near = {101.2, 101.3, 101.4};
  EXPECT_LT(largest_error(near, 1, 1e-9), 0.02);
  EXPECT_GT(largest_error(near, 1, 1e-9), 1e-9);  // of the other one
}

TEST(FrfSlopes, AreNotKnownWhereALineIsNot) {
  std::vector<MeasuredFrfs> lines;
  const std::vector<double> frequency = {100.0, 101.0, 102.0};
  for (const double f : frequency) lines.push_back(line_at(f, 1e-3));
  lines[2].at(1, 0).value = {NAN, NAN};
  const FrfSlopes slopes({0, 1, 2}, frequency, {&lines[0], &lines[1], &lines[2]}, 1);
  EXPECT_TRUE(std::isnan(slopes.of({1, 0}).real()));
  EXPECT_TRUE(std::isfinite(slopes.of({2, 0}).real()));
}

}  // namespace
}  // namespace jointid::ident
