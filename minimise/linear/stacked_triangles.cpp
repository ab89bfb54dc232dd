#include "minimise/linear/stacked_triangles.hpp"

#include <Eigen/SparseCore>
#include <cmath>

#include "base/eigen.hpp"
#include "minimise/linear/column_scaling.hpp"

namespace jointid::minimise {

StackedTriangles::StackedTriangles(const Accumulator& accumulator) {
  matrix.columns = accumulator.columns();
  std::vector<double> norm2(matrix.columns, 0.0);
  std::size_t entries = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    entries += columns.size() * (columns.size() + 1) / 2;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      for (std::size_t i = 0; i <= j; ++i) norm2[columns[j]] += triangle(i, j) * triangle(i, j);
    }
  }
  for (const double square : norm2) {
    scale.push_back(power_of_two_scale(std::sqrt(square)));
    column_norm.push_back(std::sqrt(square));
  }
  matrix.row.reserve(entries);
  matrix.column.reserve(entries);
  matrix.value.reserve(entries);
  for (const auto& [columns, triangle] : accumulator.triangles()) append(columns, triangle);
}

void StackedTriangles::append(const std::vector<std::size_t>& columns, const Triangle& triangle) {
  const std::size_t n = columns.size();
  for (std::size_t i = 0; i <= n; ++i, ++matrix.rows) {
    for (std::size_t j = i; j < n; ++j) {
      matrix.row.push_back(static_cast<std::int64_t>(matrix.rows));
      matrix.column.push_back(static_cast<std::int64_t>(columns[j]));
      matrix.value.push_back(triangle(i, j) * scale[columns[j]]);
    }
    right.push_back(triangle(i, n));
  }
}

std::vector<double> StackedTriangles::product(const std::vector<double>& y) const {
  std::vector<double> out(matrix.rows, 0.0);
  for (std::size_t e = 0; e < matrix.value.size(); ++e) {
    out[static_cast<std::size_t>(matrix.row[e])] += matrix.value[e] * y[static_cast<std::size_t>(matrix.column[e])];
  }
  return out;
}

std::vector<double> StackedTriangles::residual(const std::vector<double>& y) const {
  std::vector<double> out = right;
  for (std::size_t e = 0; e < matrix.value.size(); ++e) {
    out[static_cast<std::size_t>(matrix.row[e])] -= matrix.value[e] * y[static_cast<std::size_t>(matrix.column[e])];
  }
  return out;
}

std::vector<double> StackedTriangles::transposed(const std::vector<double>& r) const {
  std::vector<double> out(matrix.columns, 0.0);
  for (std::size_t e = 0; e < matrix.value.size(); ++e) {
    out[static_cast<std::size_t>(matrix.column[e])] += matrix.value[e] * r[static_cast<std::size_t>(matrix.row[e])];
  }
  return out;
}

SparseSymmetric normal_matrix(const StackedTriangles& stacked) {
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  const SparseEntries& entries = stacked.matrix;
  std::vector<Eigen::Triplet<double, std::int64_t>> triplets;
  triplets.reserve(entries.value.size());
  for (std::size_t e = 0; e < entries.value.size(); ++e) triplets.emplace_back(entries.row[e], entries.column[e], entries.value[e]);
  Matrix a(at(entries.rows), at(entries.columns));
  a.setFromTriplets(triplets.begin(), triplets.end());
  const Matrix whole = Matrix(a.transpose()) * a;
  const Matrix product = whole.triangularView<Eigen::Lower>();
  const std::int64_t* start = product.outerIndexPtr();
  const auto count = static_cast<std::size_t>(product.nonZeros());
  return {{start, start + product.cols() + 1},
          {product.innerIndexPtr(), product.innerIndexPtr() + count},
          {product.valuePtr(), product.valuePtr() + count}};
}

}  // namespace jointid::minimise
