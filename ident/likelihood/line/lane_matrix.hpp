#pragma once

#include <cstddef>
#include <vector>

#include "base/complex.hpp"

namespace jointid::ident {

/// A small complex matrix as columns of real and of imaginary parts, filled up to a multiple of four rows, for products by
/// registers of four numbers: Eigen's packing takes longer than the product of a few rows.
class LaneMatrix {
 public:
  /// Zero.
  LaneMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), stride_((rows + 3) / 4 * 4), values_(2 * stride_ * columns, 0.0) {}

  /// Elements by `at(row, column)`.
  template <class At>
  LaneMatrix(std::size_t rows, std::size_t columns, const At& at) : LaneMatrix(rows, columns) {
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < rows; ++i) put(i, j, at(i, j));
    }
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  Complex operator()(std::size_t row, std::size_t column) const {
    const double* const value = values_.data() + 2 * column * stride_ + row;
    return {value[0], value[stride_]};
  }
  void put(std::size_t row, std::size_t column, Complex value) {
    double* const to = values_.data() + 2 * column * stride_ + row;
    to[0] = value.real();
    to[stride_] = value.imag();
  }

  /// A factor of a product: the matrix, its conjugate, transpose or adjoint.
  struct Factor {
    const LaneMatrix* of;
    bool transposed = false, conjugated = false;
  };
  Factor transpose() const { return {this, true, false}; }
  Factor conjugate() const { return {this, false, true}; }
  Factor adjoint() const { return {this, true, true}; }
  Factor plain() const { return {this}; }

  /// Adds sign · left · right; the left factor is not transposed.
  void add_product(const Factor& left, const Factor& right, double sign = 1.0);

 private:
  std::size_t rows_, columns_, stride_;
  std::vector<double> values_;
};

}  // namespace jointid::ident
