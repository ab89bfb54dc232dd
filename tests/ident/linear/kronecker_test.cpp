#include "ident/equations/kronecker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "random_product.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

/// A selection of a product's rows, columns and DOFs with weights.
struct Selection {
  std::vector<std::size_t> a_dofs, b_dofs, rows, columns;
  std::vector<double> row_weight, column_weight;

  SubProduct part() const { return {a_dofs, b_dofs, rows, columns, row_weight, column_weight}; }
};

std::vector<std::size_t> some_of(std::size_t count, std::mt19937_64& random) {
  std::vector<std::size_t> all(count), chosen;
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::size_t size = std::uniform_int_distribution<std::size_t>(1, count)(random);
  std::sample(all.begin(), all.end(), std::back_inserter(chosen), static_cast<std::ptrdiff_t>(size), random);
  return chosen;
}

Selection selection(std::size_t m, std::size_t n, std::size_t l, std::mt19937_64& random) {
  Selection s{some_of(n, random), some_of(n, random), some_of(m, random), some_of(l, random), {}, {}};
  std::uniform_real_distribution<double> decades(-3.0, 3.0);
  for (std::size_t i = 0; i < s.rows.size(); ++i) s.row_weight.push_back(std::pow(10.0, decades(random)));
  for (std::size_t i = 0; i < s.columns.size(); ++i) s.column_weight.push_back(std::pow(10.0, decades(random)));
  return s;
}

/// All weighted equations one below the other, [A(m,p)·B(q,l) … | C₁ − C₂].
MatrixXcd stacked(const minimise::LineProduct& line, const SubProduct& part) {
  const std::size_t na = part.a_dofs.size(), nb = part.b_dofs.size(), columns = part.columns.size();
  MatrixXcd e(index_of(part.rows.size() * columns), index_of(na * nb + 1));
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const Index row = index_of(i * columns + j);
      const std::size_t m = part.rows[i], l = part.columns[j];
      const double weight = part.row_weight[i] * part.column_weight[j];
      for (std::size_t p = 0; p < na; ++p) {
        const Complex a = line.a_is_unit ? Complex(m == part.a_dofs[p] ? 1.0 : 0.0) : line.a(m, part.a_dofs[p]);
        for (std::size_t q = 0; q < nb; ++q) e(row, index_of(p * nb + q)) = weight * a * line.b(part.b_dofs[q], l);
      }
      e(row, index_of(na * nb)) = weight * (line.c1(m, l) - line.c2(m, l));
    }
  }
  return e;
}

/// The same of R_A Z R_Bᵀ = C''.
MatrixXcd stacked(const Compressed& compressed) {
  const MatrixXcd a = dense(compressed.ra), b = dense(compressed.rb), c = dense(compressed.c);
  MatrixXcd e(a.rows() * b.rows(), a.cols() * b.cols() + 1);
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < b.rows(); ++j) {
      for (Index p = 0; p < a.cols(); ++p) {
        for (Index q = 0; q < b.cols(); ++q) e(i * b.rows() + j, p * b.cols() + q) = a(i, p) * b(j, q);
      }
      e(i * b.rows() + j, e.cols() - 1) = c(i, j);
    }
  }
  return e;
}

/// EᴴE and Eᴴg agree; gᴴg only shrinks, by the part of g that no Z can explain.
void expect_same_least_squares(const MatrixXcd& expected, const MatrixXcd& found) {
  const Eigen::VectorXd scale = expected.colwise().norm().transpose();
  const MatrixXcd one = expected.adjoint() * expected, two = found.adjoint() * found;
  for (Index i = 0; i < one.rows(); ++i) {
    for (Index j = 0; j + 1 < one.cols(); ++j) {
      ASSERT_LE(std::abs(one(i, j) - two(i, j)), 1e-12 * scale[i] * scale[j]) << i << ", " << j;
    }
  }
  const Index last = one.rows() - 1;
  EXPECT_LE(two(last, last).real(), one(last, last).real() * (1.0 + 1e-12));
}

void check(const RandomProduct& product, const Selection& selected, bool a_is_unit = false) {
  minimise::LineProduct line = product.line();
  if (a_is_unit) line.a = {};
  line.a_is_unit = a_is_unit;
  const SubProduct part = selected.part();
  const MatrixXcd plain = stacked(line, part);
  Compressed compressed;
  KroneckerCompressor compressor;
  compressor.compress(line, part, false, compressed);
  EXPECT_EQ(compressed.ra.rows, std::min(part.rows.size(), part.a_dofs.size()));
  EXPECT_EQ(compressed.rb.rows, std::min(part.columns.size(), part.b_dofs.size()));
  expect_same_least_squares(plain, stacked(compressed));
  Compressed copied;
  KroneckerCompressor::copy(line, part, copied);
  ASSERT_EQ(copied.c.rows * copied.c.columns, part.rows.size() * part.columns.size());
  EXPECT_LE((stacked(copied) - plain).norm(), 1e-14 * plain.norm());
}

RC_GTEST_PROP(Kronecker, CompressedEquationsHaveTheSameNormalEquations, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::size_t> size(1, 12);
  const std::size_t m = size(random), n = size(random) / 2 + 1, l = size(random) * 2;
  const RandomProduct product(m, n, l, random);
  check(product, selection(m, n, l, random));
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Kronecker, HoldsWithZeroAndDependentColumns, (unsigned seed)) {
  std::mt19937_64 random(seed);
  RandomProduct product(6, 4, 9, random);
  product.a.col(1).setZero();
  product.a.col(3) = Complex(2.0, -1.0) * product.a.col(0);
  product.b.row(0).setZero();
  product.b.col(2).setZero();
  check(product, selection(6, 4, 9, random));
  product.a.setZero();
  check(product, selection(6, 4, 9, random));
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Kronecker, HoldsForTheUnitMatrix, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const RandomProduct product(4, 4, 7, random);
  check(product, selection(4, 4, 7, random), true);
  RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(Kronecker, OneEquationAndFewRowsOrColumns) {
  std::mt19937_64 random(1);
  for (const auto& [m, n, l] : {std::array<std::size_t, 3>{1, 1, 1}, {1, 5, 1}, {2, 5, 20}, {20, 5, 2}, {1, 3, 40}, {40, 3, 40}}) {
    const RandomProduct product(m, n, l, random);
    Selection all{std::vector<std::size_t>(n), std::vector<std::size_t>(n), std::vector<std::size_t>(m),
                  std::vector<std::size_t>(l), std::vector<double>(m, 1.0), std::vector<double>(l, 1.0)};
    for (auto* list : {&all.a_dofs, &all.b_dofs, &all.rows, &all.columns}) std::iota(list->begin(), list->end(), std::size_t{0});
    check(product, all);
  }
}

TEST(Kronecker, TheFactorOfAMayBeKeptForOtherColumnsOfTheLine) {
  std::mt19937_64 random(3);
  const RandomProduct product(9, 4, 12, random);
  const Selection first = selection(9, 4, 12, random);
  Selection second = selection(9, 4, 12, random);
  second.rows = first.rows;
  second.row_weight = first.row_weight;
  second.a_dofs = first.a_dofs;
  KroneckerCompressor keeps;
  Compressed kept, fresh;
  keeps.compress(product.line(), first.part(), false, kept);
  keeps.compress(product.line(), second.part(), true, kept);
  KroneckerCompressor().compress(product.line(), second.part(), false, fresh);
  EXPECT_EQ(dense(kept.ra), dense(fresh.ra));
  EXPECT_EQ(dense(kept.rb), dense(fresh.rb));
  EXPECT_EQ(dense(kept.c), dense(fresh.c));
}

TEST(Kronecker, ACompressorThatHasSeenALargeLineForgetsIt) {
  std::mt19937_64 random(2);
  KroneckerCompressor used;
  const RandomProduct large(15, 5, 20, random), small(3, 2, 4, random);
  const Selection of_large = selection(15, 5, 20, random), of_small = selection(3, 2, 4, random);
  Compressed out, fresh;
  used.compress(large.line(), of_large.part(), false, out);
  used.compress(small.line(), of_small.part(), false, out);
  KroneckerCompressor().compress(small.line(), of_small.part(), false, fresh);
  EXPECT_EQ(dense(out.ra), dense(fresh.ra));
  EXPECT_EQ(dense(out.rb), dense(fresh.rb));
  EXPECT_EQ(dense(out.c), dense(fresh.c));
}

}  // namespace
}  // namespace jointid::ident
