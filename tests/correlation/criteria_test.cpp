// Criteria against an independent program, and what they see and do not see.
#include "correlation/criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/correlation/golden_case.hpp"

namespace jointid::correlation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// FRFs to one column over the lines [coordinate × line].
MatrixXcd column_over_lines(const std::vector<MatrixXcd>& lines, Index column) {
  MatrixXcd out(lines.front().rows(), static_cast<Index>(lines.size()));
  for (Index i = 0; i < out.cols(); ++i) out.col(i) = lines[static_cast<std::size_t>(i)].col(column);
  return out;
}

std::vector<Complex> row_of(const MatrixXcd& of, Index r) { return {of.row(r).begin(), of.row(r).end()}; }

void expect_list(const Eigen::VectorXd& found, const golden::json& expected) {
  ASSERT_EQ(static_cast<std::size_t>(found.size()), expected.size());
  for (Index i = 0; i < found.size(); ++i) EXPECT_NEAR(found(i), expected[static_cast<std::size_t>(i)].get<double>(), 2e-9) << i;
}

TEST(GoldenCriteria, OfFrfs) {
  CORRELATION_CASE(given, "expansion");
  const golden::json expected = golden::case_named("criteria")["expected"];
  const MatrixXcd a = column_over_lines(golden::lines(given["given"]["parent"], 4), 0),
                  b = column_over_lines(golden::lines(given["given"]["overlay_of"], 4), 0);
  for (Index r = 0; r < 4; ++r)
    EXPECT_NEAR(frac(row_of(a, r), row_of(b, r)), expected["frac_column_0"][static_cast<std::size_t>(r)].get<double>(), 2e-9)
        << r;
  EXPECT_LT((fdac(a, b) - golden::real_matrix(expected["fdac"])).cwiseAbs().maxCoeff(), 2e-9);
  Eigen::VectorXd amplitude(a.cols()), lacs(a.cols()), coherences(a.cols());
  for (Index i = 0; i < a.cols(); ++i) {
    amplitude(i) = amplitude_criterion(std::span(a.col(i).data(), 4), std::span(b.col(i).data(), 4));
    lacs(i) = lac(a(1, i), b(1, i));
    coherences(i) = coherence_criterion(a(1, i), b(1, i));
  }
  expect_list(amplitude, expected["amplitude"]);
  expect_list(lacs, expected["lac_0_1"]);
  expect_list(coherences, expected["coherence_0_1"]);
}

TEST(GoldenCriteria, OfModes) {
  CORRELATION_CASE(given, "expansion");
  const golden::json expected = golden::case_named("criteria")["expected"];
  const MatrixXcd one = golden::real_matrix(given["given"]["modes_parent"]).cast<Complex>(),
                  other = golden::real_matrix(given["given"]["modes_true"]).cast<Complex>();
  const MatrixXd mac = mac_matrix(one, other);
  EXPECT_LT((mac - golden::real_matrix(expected["mac"])).cwiseAbs().maxCoeff(), 2e-9);
  const auto pairs = paired(mac);
  for (std::size_t r = 0; r < 4; ++r) EXPECT_EQ(pairs[r], std::optional<std::size_t>(r));
  expect_list(comac(one, other), expected["comac"]);
  expect_list(ecomac(one, other), expected["ecomac"]);
}

struct Drawn : testing::TestWithParam<unsigned> {
  std::mt19937 generator{GetParam()};

  MatrixXcd draw(Index rows, Index columns) {
    std::normal_distribution<double> normal;
    return MatrixXcd::NullaryExpr(rows, columns, [&] { return Complex(normal(generator), normal(generator)); });
  }
};

TEST_P(Drawn, WhatCriteriaSee) {
  const MatrixXcd a = draw(7, 5), b = draw(7, 5);
  const Complex factor(0.4, -1.7);
  const std::vector<Complex> x = row_of(a, 0), y = row_of(b, 0), turned = row_of(factor * a, 0);
  EXPECT_NEAR(frac(x, turned), 1.0, 1e-14);    // no factor
  EXPECT_NEAR(frac(x, y), frac(y, x), 1e-14);  // symmetric
  EXPECT_LE(frac(x, y), 1.0);
  EXPECT_LT(amplitude_criterion(x, turned), 0.9);                                // the factor
  EXPECT_NEAR(lac(x[0], x[0] * Complex(0.0, 1.0)), 1.0, 1e-14);                  // no phase
  EXPECT_NEAR(coherence_criterion(x[0], x[0] * Complex(0.0, 1.0)), 0.5, 1e-14);  // the phase
  EXPECT_NEAR(coherence_criterion(x[0], -x[0]), 0.0, 1e-14);
  EXPECT_LT((fdac(a, b) - fdac(b, a).transpose()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((comac(a, a * Eigen::VectorXcd::Constant(5, Complex(0.0, 1.0)).asDiagonal()).array() - 1.0).abs().maxCoeff(), 1e-13);
  EXPECT_LT(ecomac(a, factor * a).cwiseAbs().maxCoeff(), 1e-13);
}

/// 1 − FRAC ≈ p²(1 − Σ|a|⁴/(Σ|a|²)²) for circular noise of level p on one of two.
TEST_P(Drawn, NoiseLeavesWhatTheFormulaSays) {
  constexpr double level = 0.01;
  const MatrixXcd a = draw(1, 40);
  double sum = 0.0, square = 0.0, left = 0.0;
  for (const Complex& each : row_of(a, 0)) {
    sum += std::norm(each);
    square += std::norm(each) * std::norm(each);
  }
  constexpr int trials = 400;
  for (int t = 0; t < trials; ++t) {
    const MatrixXcd noise = draw(1, 40) * (level / std::sqrt(2.0));
    left += 1.0 - frac(row_of(a, 0), row_of(a.cwiseProduct(MatrixXcd::Ones(1, 40) + noise), 0));
  }
  EXPECT_NEAR(left / trials / (level * level * (1.0 - square / (sum * sum))), 1.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Drawn, testing::Range(1u, 9u));

TEST(Criteria, LeaveOutWhatIsNoNumber) {
  const double gap = std::nan("");
  const std::vector<Complex> a = {{1.0, 2.0}, {gap, 0.0}, {3.0, -1.0}}, b = {{2.0, 4.0}, {1.0, 1.0}, {6.0, -2.0}};
  EXPECT_NEAR(frac(a, b), 1.0, 1e-15);
  EXPECT_TRUE(std::isnan(frac(std::vector<Complex>{}, std::vector<Complex>{})));
  EXPECT_TRUE(std::isnan(lac(0.0, 0.0)));
}

/// A mode that two modes resemble goes to the one that it resembles more; the other has no partner.
TEST(Criteria, PairEachModeOnce) {
  MatrixXd mac(2, 2);
  mac << 0.9, 0.2, 0.95, 0.3;
  const auto pairs = paired(mac, 0.25);
  EXPECT_EQ(pairs[1], std::optional<std::size_t>(0));
  EXPECT_FALSE(pairs[0]);
}

}  // namespace
}  // namespace jointid::correlation
