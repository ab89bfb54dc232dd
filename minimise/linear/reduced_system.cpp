#include "minimise/linear/reduced_system.hpp"

#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "minimise/linear/column_scaling.hpp"

namespace jointid::minimise {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd dense(const Triangle& triangle) {
  const std::size_t n = triangle.unknowns();
  MatrixXd system = MatrixXd::Zero(at(n + 1), at(n + 1));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = i; j <= n; ++j) system(at(i), at(j)) = triangle(i, j);
  }
  return system;
}

/// Some P with PᵀP = product, from the eigenvalues of the product with unit diagonal.
MatrixXd scaled_root(const MatrixXd& product) {
  const Index n = product.rows();
  Eigen::VectorXd scale(n);
  for (Index j = 0; j < n; ++j) scale[j] = power_of_two_scale(std::sqrt(product(j, j)));
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(scale.asDiagonal() * product * scale.asDiagonal());
  return eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() * eigen.vectors.transpose() * scale.cwiseInverse().asDiagonal();
}

}  // namespace

MatrixXd reduced_system(const Accumulator& accumulator) {
  if (accumulator.reduction() == Reduction::normal) return scaled_root(normal_product(accumulator));
  const std::size_t n = accumulator.columns();
  const auto& triangles = accumulator.triangles();
  if (triangles.size() == 1 && triangles.begin()->first.size() == n) return dense(triangles.begin()->second);
  Triangle whole(n);
  for (const auto& [columns, triangle] : triangles) {
    for (std::size_t i = 0; i <= columns.size(); ++i) {
      double* row = whole.append(1);
      for (std::size_t j = i; j < columns.size(); ++j) row[columns[j]] = triangle(i, j);
      row[n] = triangle(i, columns.size());
    }
  }
  whole.flush();
  return dense(whole);
}

MatrixXd normal_product(const Accumulator& accumulator) {
  const Index n = at(accumulator.columns());
  MatrixXd product = MatrixXd::Zero(n + 1, n + 1);
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    std::vector<std::size_t> place = columns;
    place.push_back(accumulator.columns());
    for (std::size_t i = 0; i < place.size(); ++i) {
      for (std::size_t j = i; j < place.size(); ++j) product(at(place[i]), at(place[j])) += triangle(i, j);
    }
  }
  return product.selfadjointView<Eigen::Upper>();
}

}  // namespace jointid::minimise
