#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "minimise/linear/complex_triangle.hpp"
#include "minimise/linear/triangle.hpp"

namespace jointid::minimise {

/// The reduced least-squares system of all lines seen so far: one running triangle per set of columns that equations touch
/// together. An ordinary scene has one triangle over all unknowns; uncoupled substructures with many joints, and joints
/// identified per band, have several over few columns each, which together are a sparse system.
class Accumulator {
 public:
  using Columns = std::vector<std::size_t>;

  explicit Accumulator(std::size_t columns, Reduction reduction = Reduction::orthogonal)
      : columns_(columns), reduction_(reduction) {}

  /// The triangle for rows that touch just these columns of the whole system.
  Triangle& triangle(const Columns& columns);

  /// The same for complex rows in z = k + i·d: of the unknown u, k is column real[u] of `columns`, d column imaginary[u].
  ComplexTriangle& complex_triangle(const Columns& columns, const Columns& real, const Columns& imaginary);

  std::size_t columns() const { return columns_; }
  Reduction reduction() const { return reduction_; }
  const std::map<Columns, Triangle>& triangles() const { return triangles_; }
  std::size_t rows_pushed() const;  ///< since the last clear(), after flush()
  std::size_t bytes() const;        ///< of all triangles and buffers

  /// Reduces all buffers and moves complex rows into the real triangles; needed before the triangles are read.
  void flush();

  /// Frees the buffers after flush(), where the system is kept and no rows follow soon.
  void release();
  void merge(Accumulator& other);

  /// All triangles as numbers, for another process; flushes before.
  std::vector<double> packed();
  void merge_packed(std::span<const double> packed);
  void clear();

 private:
  std::size_t columns_;
  Reduction reduction_;
  struct ComplexPart {
    ComplexTriangle triangle;
    Columns real, imaginary;
  };
  std::map<Columns, Triangle> triangles_;
  std::map<Columns, ComplexPart> complex_;
};

}  // namespace jointid::minimise
