#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "base/eigen.hpp"
#include "ident/equations/kronecker.hpp"

namespace jointid::ident {

inline Eigen::Index index_of(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// A random line A Z B = C₁ − C₂ that owns its matrices.
class RandomProduct {
 public:
  RandomProduct(std::size_t m, std::size_t n, std::size_t l, std::mt19937_64& random)
      : a(fill(m, n, random)), b(fill(n, l, random)), c1(fill(m, l, random)), c2(fill(m, l, random)) {
    std::bernoulli_distribution coin;
    for (std::size_t i = 0; i < m; ++i) row_class.push_back(coin(random));
    for (std::size_t j = 0; j < l; ++j) column_class.push_back(coin(random));
  }

  minimise::LineProduct line() const {
    minimise::LineProduct product;
    product.a = view(a);
    product.b = view(b);
    product.c1 = view(c1);
    product.c2 = view(c2);
    product.row_class = row_class;
    product.column_class = column_class;
    return product;
  }

  static minimise::View view(const RowMatrixXc& matrix) {
    const auto rows = static_cast<std::size_t>(matrix.rows()), columns = static_cast<std::size_t>(matrix.cols());
    return {matrix.data(), rows, columns, columns};
  }

  RowMatrixXc a, b, c1, c2;
  std::vector<std::uint8_t> row_class, column_class;

 private:
  static RowMatrixXc fill(std::size_t rows, std::size_t columns, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    RowMatrixXc matrix(index_of(rows), index_of(columns));
    for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = {normal(random), normal(random)};
    return matrix;
  }
};

inline Eigen::MatrixXcd dense(const SplitMatrix& split) {
  Eigen::MatrixXcd matrix(index_of(split.rows), index_of(split.columns));
  for (std::size_t i = 0; i < split.rows; ++i) {
    for (std::size_t j = 0; j < split.columns; ++j) {
      matrix(index_of(i), index_of(j)) = {split.re[i * split.columns + j], split.im[i * split.columns + j]};
    }
  }
  return matrix;
}

}  // namespace jointid::ident
