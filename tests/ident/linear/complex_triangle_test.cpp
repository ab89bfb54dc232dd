#include "minimise/linear/complex_triangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <random>

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// [Re E, −Im E, Re p; Im E, Re E, Im p] with the columns where pour() is told to put them.
MatrixXd real_form(const MatrixXcd& rows, const std::vector<std::size_t>& real, const std::vector<std::size_t>& imaginary) {
  const Index n = rows.cols() - 1;
  MatrixXd out = MatrixXd::Zero(2 * rows.rows(), 2 * n + 1);
  for (Index j = 0; j < n; ++j) {
    const auto k = static_cast<Index>(real[static_cast<std::size_t>(j)]);
    const auto d = static_cast<Index>(imaginary[static_cast<std::size_t>(j)]);
    out.col(k) << rows.col(j).real(), rows.col(j).imag();
    out.col(d) << -rows.col(j).imag(), rows.col(j).real();
  }
  out.col(2 * n) << rows.col(n).real(), rows.col(n).imag();
  return out;
}

MatrixXd product_of(minimise::Triangle& triangle) {
  triangle.flush();
  const auto width = static_cast<Index>(triangle.unknowns() + 1);
  MatrixXd r = MatrixXd::Zero(width, width);
  for (Index i = 0; i < width; ++i) {
    for (Index j = i; j < width; ++j) r(i, j) = triangle(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  return r.transpose() * r;
}

void push(const MatrixXcd& rows, Index first, Index count, minimise::ComplexTriangle& to) {
  double* row = to.append(static_cast<std::size_t>(count));
  const auto half = static_cast<Index>(to.stride() / 2);
  for (Index i = 0; i < count; ++i, row += to.stride()) {
    for (Index j = 0; j < rows.cols(); ++j) {
      row[j] = rows(first + i, j).real();
      row[half + j] = rows(first + i, j).imag();
    }
  }
}

RC_GTEST_PROP(ComplexTriangle, PouredItIsTheRealTriangleOfItsRows, (unsigned seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Index n = std::uniform_int_distribution<Index>(1, 20)(random), m = std::uniform_int_distribution<Index>(1, 300)(random);
  MatrixXcd rows(m, n + 1);
  for (auto& value : rows.reshaped()) value = {normal(random), normal(random)};
  if (seed % 3 == 0) rows.col(0).setZero();
  std::vector<std::size_t> columns(2 * static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = i;
  std::shuffle(columns.begin(), columns.end(), random);
  const std::vector<std::size_t> real(columns.begin(), columns.begin() + n), imaginary(columns.begin() + n, columns.end());

  minimise::ComplexTriangle complex(static_cast<std::size_t>(n));
  minimise::Triangle poured(columns.size());
  for (Index first = 0; first < m;) {
    const Index count = std::min(m - first, std::uniform_int_distribution<Index>(1, 150)(random));
    push(rows, first, count, complex);
    first += count;
    // Pouring in between must neither lose nor repeat rows.
    if (random() % 4 == 0) complex.pour(real, imaginary, poured);
  }
  complex.pour(real, imaginary, poured);
  complex.pour(real, imaginary, poured);
  const MatrixXd plain = real_form(rows, real, imaginary);
  const MatrixXd expected = plain.transpose() * plain;
  RC_ASSERT((product_of(poured) - expected).norm() <= 1e-12 * expected.norm());
}

}  // namespace
}  // namespace jointid::ident
