#include "minimise/linear/triangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <random>

#include "minimise/linear/accumulator.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Random rows of very different magnitude.
MatrixXd random_rows(Index rows, Index columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> decades(-4.0, 4.0);
  MatrixXd x(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    const double magnitude = std::pow(10.0, decades(random));
    for (Index j = 0; j < columns; ++j) x(i, j) = magnitude * normal(random);
  }
  return x;
}

void push(minimise::Triangle& triangle, const MatrixXd& x, Index first, Index count) {
  double* rows = triangle.append(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < x.cols(); ++j) rows[i * static_cast<Index>(triangle.stride()) + j] = x(first + i, j);
  }
}

/// Pushes all rows in chunks of random size.
void push_all(minimise::Triangle& triangle, const MatrixXd& x, std::mt19937_64& random) {
  std::uniform_int_distribution<Index> chunk(1, 1 + x.rows() / 2);
  for (Index first = 0; first < x.rows();) {
    const Index count = std::min(chunk(random), x.rows() - first);
    push(triangle, x, first, count);
    first += count;
  }
}

MatrixXd upper(const minimise::Triangle& triangle) {
  const Index n = static_cast<Index>(triangle.unknowns()) + 1;
  MatrixXd r = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = i; j < n; ++j) r(i, j) = triangle(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  return r;
}

void expect_gram(const MatrixXd& found, const MatrixXd& x, double tolerance) {
  const MatrixXd expected = x.transpose() * x;
  const Eigen::VectorXd scale = x.colwise().norm().transpose();
  for (Index i = 0; i < expected.rows(); ++i) {
    for (Index j = 0; j < expected.cols(); ++j) {
      ASSERT_LE(std::abs(found(i, j) - expected(i, j)), tolerance * scale[i] * scale[j]) << i << ", " << j;
    }
  }
}

struct Sizes {
  std::size_t unknowns;
  Index rows;
};

Sizes sizes(std::mt19937_64& random) {
  return {std::uniform_int_distribution<std::size_t>(0, 40)(random), std::uniform_int_distribution<Index>(1, 400)(random)};
}

RC_GTEST_PROP(Triangle, ItsProductIsThatOfTheRows, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const auto [unknowns, rows] = sizes(random);
  const MatrixXd x = random_rows(rows, static_cast<Index>(unknowns) + 1, random);
  minimise::Triangle triangle(unknowns);
  push_all(triangle, x, random);
  triangle.flush();
  RC_ASSERT(triangle.rows_pushed() == static_cast<std::size_t>(rows));
  const MatrixXd r = upper(triangle);
  expect_gram(r.transpose() * r, x, 1e-13);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Triangle, InNormalModeItIsTheProduct, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const auto [unknowns, rows] = sizes(random);
  const MatrixXd x = random_rows(rows, static_cast<Index>(unknowns) + 1, random);
  minimise::Triangle triangle(unknowns, minimise::Reduction::normal);
  push_all(triangle, x, random);
  triangle.flush();
  const MatrixXd product = upper(triangle).selfadjointView<Eigen::Upper>();
  expect_gram(product, x, 1e-13);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Triangle, MergedTrianglesHoldTheRowsOfBoth, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const auto [unknowns, rows] = sizes(random);
  const MatrixXd x = random_rows(2 * rows, static_cast<Index>(unknowns) + 1, random);
  for (const minimise::Reduction reduction : {minimise::Reduction::orthogonal, minimise::Reduction::normal}) {
    minimise::Triangle one(unknowns, reduction), two(unknowns, reduction);
    push_all(one, x.topRows(rows), random);
    push_all(two, x.bottomRows(rows), random);
    one.merge(two);
    one.flush();
    RC_ASSERT(one.rows_pushed() == static_cast<std::size_t>(2 * rows));
    const MatrixXd r = upper(one);
    const MatrixXd product =
        reduction == minimise::Reduction::normal ? MatrixXd(r.selfadjointView<Eigen::Upper>()) : MatrixXd(r.transpose() * r);
    expect_gram(product, x, 1e-13);
  }
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Triangle, TheOrderOfRowsChangesSignsOnly, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const std::size_t unknowns = std::uniform_int_distribution<std::size_t>(0, 12)(random);
  const Index n = static_cast<Index>(unknowns) + 1;
  const MatrixXd x = MatrixXd::Random(3 * n + 5, n);
  std::vector<Index> order(static_cast<std::size_t>(x.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  std::shuffle(order.begin(), order.end(), random);
  minimise::Triangle straight(unknowns), shuffled(unknowns);
  push_all(straight, x, random);
  for (const Index row : order) push(shuffled, x, row, 1);
  straight.flush();
  shuffled.flush();
  const MatrixXd one = upper(straight), two = upper(shuffled);
  for (Index i = 0; i < n; ++i) {
    const double sign = one(i, i) * two(i, i) < 0.0 ? -1.0 : 1.0;
    RC_ASSERT((one.row(i) - sign * two.row(i)).norm() <= 1e-11 * one.norm());
  }
}

TEST(Triangle, WithoutRowsItIsZeroAndZeroRowsChangeNothing) {
  minimise::Triangle triangle(3);
  triangle.flush();
  EXPECT_EQ(upper(triangle), MatrixXd::Zero(4, 4));
  triangle.append(5);
  triangle.flush();
  EXPECT_EQ(upper(triangle), MatrixXd::Zero(4, 4));
  EXPECT_EQ(triangle.rows_pushed(), 5u);
}

TEST(Triangle, NewRowsAreZeroFilledAfterReduction) {
  std::mt19937_64 random(3);
  for (const minimise::Reduction reduction : {minimise::Reduction::orthogonal, minimise::Reduction::normal}) {
    minimise::Triangle triangle(9, reduction);
    push_all(triangle, random_rows(500, 10, random), random);
    triangle.flush();
    const double* rows = triangle.append(40);
    EXPECT_TRUE(std::all_of(rows, rows + 40 * triangle.stride(), [](double value) { return value == 0.0; }));
  }
}

TEST(Triangle, RowsWithWeightsFourteenDecadesApartKeepTheLightOnes) {
  // Two heavy rows fix x₁ − x₂, two light ones x₁ + x₂; the product would lose the light ones.
  minimise::Triangle triangle(2);
  MatrixXd x(4, 3);
  x << 1e7, -1e7, 1e7, 1e-7, 1e-7, 3e-7, 1e7, -1e7, 1e7, 1e-7, 1e-7, 3e-7;
  push(triangle, x, 0, 4);
  triangle.flush();
  const MatrixXd r = upper(triangle);
  const double x2 = r(1, 2) / r(1, 1), x1 = (r(0, 2) - r(0, 1) * x2) / r(0, 0);
  EXPECT_NEAR(x1 - x2, 1.0, 1e-12);
  EXPECT_NEAR(x1 + x2, 3.0, 0.1);
}

TEST(Accumulator, KeepsOneTrianglePerSetOfColumnsAndMergesByIt) {
  std::mt19937_64 random(4);
  const MatrixXd x = random_rows(30, 3, random), y = random_rows(20, 2, random);
  minimise::Accumulator one(4), two(4), whole(4);
  push(one.triangle({0, 2}), x, 0, 10);
  push(two.triangle({0, 2}), x, 10, 20);
  push(two.triangle({3}), y, 0, 20);
  one.merge(two);
  one.flush();
  ASSERT_EQ(one.triangles().size(), 2u);
  const MatrixXd r = upper(one.triangle({0, 2})), s = upper(one.triangle({3}));
  expect_gram(r.transpose() * r, x, 1e-13);
  expect_gram(s.transpose() * s, y, 1e-13);
}

}  // namespace
}  // namespace jointid::ident
