#pragma once

#include <vector>

#include "minimise/linear/accumulator.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::minimise {

/// The stacked triangles A with columns scaled by powers of two to about unit length, their right-hand side b, and what their columns
/// were scaled by.
struct StackedTriangles {
  SparseEntries matrix;
  std::vector<double> right, scale, column_norm;

  explicit StackedTriangles(const Accumulator& accumulator);

  /// A y.
  std::vector<double> product(const std::vector<double>& y) const;
  /// b − A y.
  std::vector<double> residual(const std::vector<double>& y) const;
  /// Aᵀ r.
  std::vector<double> transposed(const std::vector<double>& r) const;

 private:
  void append(const std::vector<std::size_t>& columns, const Triangle& triangle);
};

/// AᵀA of the scaled columns.
SparseSymmetric normal_matrix(const StackedTriangles& stacked);

}  // namespace jointid::minimise
