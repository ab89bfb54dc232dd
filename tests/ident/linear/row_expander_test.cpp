#include "ident/equations/row_expander.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <numeric>

#include "restrictions/impedance_factor.hpp"
#include "tests/ident/memory_systems.hpp"
#include "random_product.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using restrictions::EntryMatrix;
using restrictions::Kind;
using restrictions::Pattern;

/// A joint with all four matrices: patterns, tied and known elements, springs.
restrictions::Restriction all_matrices() {
  restrictions::JointSpec joint;
  joint.dofs = dofs({"4:+Y", "4:+RZ", "5:+Y"});
  joint.matrices[Kind::stiffness] = EntryMatrix{{"a", "b", -3.0}, {"2*b-a", 5.0, "c+7"}, {"-a", "c", "a/2"}};
  joint.matrices[Kind::mass] = Pattern::symmetric;
  joint.matrices[Kind::viscous_damping] = std::vector<restrictions::Spring>{
      {joint.dofs[0], joint.dofs[2]}, {joint.dofs[1], std::nullopt}};
  joint.matrices[Kind::hysteretic_damping] = EntryMatrix{{"a", "b", 0.5}, {"2*b-a", 0.0, "c"}, {"-a", "c", "a/2"}};
  return restrictions::build({joint});
}

/// Columns of E·T_f·T, known part E·T_f·T₂y₂ last, straight from docs/formulas.md §1 and §4.
MatrixXcd expected_rows(const restrictions::Restriction& restriction, const MatrixXcd& e, double omega, double omega0) {
  const Eigen::Index elements = e.cols(), unknowns = index_of(restriction.unknowns.size());
  const Complex i(0.0, 1.0);
  const std::pair<Kind, std::pair<Complex, double>> factors[] = {
      {Kind::stiffness, {1.0, 1.0}},
      {Kind::mass, {-omega * omega, omega0 * omega0}},
      {Kind::viscous_damping, {i * omega, omega0}},
      {Kind::hysteretic_damping, {i, 1.0}}};
  MatrixXcd tf(elements, 4 * elements);
  MatrixXd t = MatrixXd::Zero(4 * elements, unknowns), known = MatrixXd::Zero(4 * elements, 1);
  std::vector<double> y(restriction.unknowns.size(), 0.0);
  const auto column = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), index_of(values.size()));
  };
  for (Eigen::Index k = 0; k < 4; ++k) {
    const auto& [kind, factor] = factors[k];
    tf.middleCols(k * elements, elements) = factor.first / factor.second * MatrixXcd::Identity(elements, elements);
    const std::vector<double> constant = restriction.matrix(kind, y);
    known.middleRows(k * elements, elements) = factor.second * column(constant);
    for (std::size_t u = 0; u < y.size(); ++u) {
      y[u] = 1.0;
      t.block(k * elements, index_of(u), elements, 1) = column(restriction.matrix(kind, y)) - column(constant);
      y[u] = 0.0;
    }
  }
  MatrixXcd rows(e.rows(), unknowns + 1);
  rows << e * tf * t, e * tf * known;
  return rows;
}

/// Rows of the expander for random compressed equations over the given part of Z_j, the other coefficients being zero.
void check(const restrictions::Restriction& restriction, const std::vector<std::size_t>& a_dofs,
           const std::vector<std::size_t>& b_dofs, const std::vector<std::size_t>& unknowns, unsigned seed) {
  std::mt19937_64 random(seed);
  const std::size_t n = restriction.dofs.size(), p_count = 2, q_count = 3;
  const RandomProduct product(p_count, a_dofs.size(), q_count, random);
  const RandomProduct other(q_count, b_dofs.size(), 1, random);
  const auto split = [](const RowMatrixXc& from, SplitMatrix& to) {
    to.resize(static_cast<std::size_t>(from.rows()), static_cast<std::size_t>(from.cols()));
    for (std::size_t i = 0; i < to.re.size(); ++i) {
      to.re[i] = from.data()[i].real();
      to.im[i] = from.data()[i].imag();
    }
  };
  Compressed compressed;
  split(product.a, compressed.ra);
  split(other.a, compressed.rb);
  split(product.c1, compressed.c);
  MatrixXcd e = MatrixXcd::Zero(index_of(p_count * q_count), index_of(n * n));
  for (std::size_t p = 0; p < p_count; ++p) {
    for (std::size_t q = 0; q < q_count; ++q) {
      for (std::size_t i = 0; i < a_dofs.size(); ++i) {
        for (std::size_t j = 0; j < b_dofs.size(); ++j) {
          e(index_of(p * q_count + q), index_of(a_dofs[i] * n + b_dofs[j])) =
              product.a(index_of(p), index_of(i)) * other.a(index_of(q), index_of(j));
        }
      }
    }
  }
  const double omega0 = 700.0, omega = std::uniform_real_distribution<double>(1.0, omega0)(random);
  const MatrixXcd expected = expected_rows(restriction, e, omega, omega0);
  RowExpander expander(restriction, a_dofs, b_dofs, unknowns, omega0);
  ASSERT_EQ(expander.unknowns(), unknowns.size());
  expander.set_line(3.0 * omega);  // a line before must leave nothing
  expander.set_line(omega);
  const std::size_t stride = unknowns.size() + 4;
  const double size = expected.norm() + product.c1.norm();
  for (std::size_t p = 0; p < p_count; ++p) {
    std::vector<double> rows(2 * q_count * stride, 0.0);
    expander.expand(compressed, p * q_count, q_count, rows.data(), stride);
    for (std::size_t q = 0; q < q_count; ++q) {
      const Eigen::Index row = index_of(p * q_count + q);
      const double* real = rows.data() + 2 * q * stride;
      const double* imaginary = real + stride;
      for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const Complex coefficient = expected(row, index_of(unknowns[u]));
        ASSERT_LE(std::abs(coefficient - Complex(real[u], imaginary[u])), 1e-13 * size) << u;
      }
      const Complex right = product.c1(index_of(p), index_of(q)) - expected(row, expected.cols() - 1);
      ASSERT_LE(std::abs(right - Complex(real[unknowns.size()], imaginary[unknowns.size()])), 1e-13 * size);
      for (std::size_t pad = unknowns.size() + 1; pad < stride; ++pad) ASSERT_EQ(real[pad], 0.0);
    }
  }
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

RC_GTEST_PROP(RowExpander, RowsAreThoseOfTheDenseProduct, (unsigned seed)) {
  const restrictions::Restriction restriction = all_matrices();
  check(restriction, first(3), first(3), first(restriction.unknowns.size()), seed);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(RowExpander, APartOfTheElementsHasTheRowsOfThatPart, (unsigned seed)) {
  const restrictions::Restriction restriction = all_matrices();
  const std::vector<std::size_t> a_dofs = {0, 2}, b_dofs = {2};
  // Unknowns with a term in column 2 of Z_j, rows 0 and 2; an unknown without one has zeros.
  check(restriction, a_dofs, b_dofs, first(restriction.unknowns.size()), seed);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(RowExpander, MatricesOfOnePatternShareTheirWorkOnly, (unsigned seed)) {
  const Dofs joint = dofs({"1:+X", "2:+X"});
  restrictions::JointSpec spec = joint_of(joint, Kind::stiffness, Pattern::full);
  for (const Kind kind : restrictions::all_kinds) spec.matrices[kind] = Pattern::full;
  const restrictions::Restriction restriction = restrictions::build({spec});
  check(restriction, first(2), first(2), first(16), seed);
  RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(RowExpander, FactorsAreThoseOfTheFormulas) {
  EXPECT_EQ(impedance_factor(Kind::stiffness, 3.0), Complex(1.0, 0.0));
  EXPECT_EQ(impedance_factor(Kind::mass, 3.0), Complex(-9.0, 0.0));
  EXPECT_EQ(impedance_factor(Kind::viscous_damping, 3.0), Complex(0.0, 3.0));
  EXPECT_EQ(impedance_factor(Kind::hysteretic_damping, 3.0), Complex(0.0, 1.0));
  EXPECT_EQ(unscale(Kind::mass, 2.0), 0.25);
  EXPECT_EQ(unscale(Kind::viscous_damping, 2.0), 0.5);
  EXPECT_EQ(unscale(Kind::stiffness, 2.0) + unscale(Kind::hysteretic_damping, 2.0), 2.0);
}

}  // namespace
}  // namespace jointid::ident
