#include "weighting/line_weights.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <random>
#include <tuple>

#include "base/complex.hpp"
#include "weighting/delta_filter.hpp"

namespace jointid::weighting {
namespace {

/// A random line A [M×N], B [N×L] with a mask; the equations in use have coefficients that are not all zero.
struct RandomLine {
  std::size_t m = 0, n = 0, l = 0;
  std::vector<Complex> a, b;
  std::vector<std::uint8_t> column_class, keep;

  explicit RandomLine(std::mt19937_64& random, bool masked) {
    std::uniform_int_distribution<std::size_t> size(1, 6);
    m = size(random), n = size(random), l = size(random);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> decades(-9.0, 3.0);
    std::bernoulli_distribution coin(0.6);
    const auto fill = [&](std::vector<Complex>& values, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        values.push_back(std::pow(10.0, decades(random)) * Complex(normal(random), normal(random)));
      }
    };
    fill(a, m * n);
    fill(b, n * l);
    for (std::size_t i = 0; i < l; ++i) column_class.push_back(coin(random));
    for (std::size_t i = 0; masked && i < m * l; ++i) keep.push_back(coin(random));
  }

  bool used(std::size_t row, std::size_t column) const { return keep.empty() || keep[row * l + column]; }

  /// Largest modulus in the coefficient row of equation (row, column), element by element.
  double largest(std::size_t row, std::size_t column) const {
    double value = 0.0;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = 0; q < n; ++q)
        value = std::max(value, std::abs(a[row * n + p] * b[q * l + column]));
    }
    return value;
  }

  LineWeights weights(Weighting weighting) const {
    std::vector<double> row_max(m), column_max(l);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t p = 0; p < n; ++p) row_max[i] = std::max(row_max[i], std::abs(a[i * n + p]));
    }
    for (std::size_t j = 0; j < l; ++j) {
      for (std::size_t q = 0; q < n; ++q) column_max[j] = std::max(column_max[j], std::abs(b[q * l + j]));
    }
    LineWeights out;
    line_weights(weighting, {row_max, column_max, column_class, keep}, out);
    return out;
  }
};

/// The group of an equation by the definitions of the weightings (WA is not a matter of this function).
std::tuple<std::size_t, std::size_t, std::size_t> group(Weighting weighting, const RandomLine& line,
                                                        std::size_t row, std::size_t column) {
  if (weighting == Weighting::wb) return {0, 0, 0};
  if (weighting == Weighting::wbg) return {1, row, line.column_class[column]};
  return {2, row, column};
}

void check_against_definition(Weighting weighting, bool masked, unsigned seed) {
  std::mt19937_64 random(seed);
  const RandomLine line(random, masked);
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> largest;
  for (std::size_t i = 0; i < line.m; ++i) {
    for (std::size_t j = 0; j < line.l; ++j) {
      double& value = largest[group(weighting, line, i, j)];
      if (line.used(i, j)) value = std::max(value, line.largest(i, j));
    }
  }
  const LineWeights weights = line.weights(weighting);
  RC_ASSERT(weights.row.size() == 2 * line.m);
  RC_ASSERT(weights.column.size() == line.l);
  for (std::size_t i = 0; i < line.m; ++i) {
    for (std::size_t j = 0; j < line.l; ++j) {
      if (!line.used(i, j)) continue;
      const double weight = weights.row[line.column_class[j] * line.m + i] * weights.column[j];
      RC_ASSERT(std::abs(weight * largest[group(weighting, line, i, j)] - 1.0) <= 1e-14);
    }
  }
}

RC_GTEST_PROP(LineWeights, AreTheDefinitionsOverAllEquations, (unsigned seed)) {
  for (const Weighting weighting : {Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    check_against_definition(weighting, false, seed);
  }
}

RC_GTEST_PROP(LineWeights, AreTheDefinitionsOverTheEquationsInUse, (unsigned seed)) {
  for (const Weighting weighting : {Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    check_against_definition(weighting, true, seed);
  }
}

RC_GTEST_PROP(LineWeights, WithoutAMaskARowHasOneWeightForBothClasses, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const RandomLine line(random, false);
  for (const Weighting weighting : {Weighting::none, Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    const LineWeights weights = line.weights(weighting);
    for (std::size_t i = 0; i < line.m; ++i) RC_ASSERT(weights.row[i] == weights.row[line.m + i]);
  }
}

RC_GTEST_PROP(LineWeights, NoneAndWaAreOnesHere, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const RandomLine line(random, seed % 2 == 0);
  for (const Weighting weighting : {Weighting::none, Weighting::wa}) {
    const LineWeights weights = line.weights(weighting);
    RC_ASSERT(weights.row == std::vector<double>(2 * line.m, 1.0));
    RC_ASSERT(weights.column == std::vector<double>(line.l, 1.0));
  }
}

TEST(LineWeights, EquationsWithoutCoefficientsGetFiniteWeights) {
  const std::vector<double> row_max = {0.0, 2.0}, column_max = {0.0, 4.0};
  const std::vector<std::uint8_t> classes = {0, 1}, keep = {0, 0, 0, 1};
  for (const Weighting weighting : {Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    LineWeights weights;
    line_weights(weighting, {row_max, column_max, classes, keep}, weights);
    for (const double weight : weights.row) EXPECT_TRUE(std::isfinite(weight)) << name(weighting);
    for (const double weight : weights.column) EXPECT_TRUE(std::isfinite(weight)) << name(weighting);
    EXPECT_DOUBLE_EQ(weights.row[2 + 1] * weights.column[1], 1.0 / 8.0) << name(weighting);
  }
}

RC_GTEST_PROP(DeltaFilter, DropsWhatTheDefinitionDrops, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Complex c1(normal(random), normal(random));
  const Complex c2 = c1 * (1.0 + 0.3 * normal(random)) + 0.1 * Complex(normal(random), normal(random));
  const double delta = std::uniform_real_distribution<double>(1e-6, 2.0)(random);
  const double share = std::abs(c1 - c2) / (0.5 * (std::abs(c1) + std::abs(c2)));
  RC_PRE(std::abs(share - delta) > 1e-12);
  RC_ASSERT(drops(delta, c1, c2) == (share < delta));
  RC_ASSERT(drops(delta, c2, c1) == drops(delta, c1, c2));
}

TEST(DeltaFilter, TheBoundItselfIsDroppedAndZeroDropsNothing) {
  EXPECT_TRUE(drops(1.0, 3.0, 1.0));  // 2·2 ≤ 1·4
  EXPECT_FALSE(drops(0.999, 3.0, 1.0));
  EXPECT_FALSE(drops(0.0, 1.0, 1.0));
  EXPECT_TRUE(drops(1e-12, 1.0, 1.0));
  EXPECT_TRUE(drops(0.5, 0.0, 0.0));
  EXPECT_FALSE(drops(1.999, 1.0, -1.0));
}

}  // namespace
}  // namespace jointid::weighting
