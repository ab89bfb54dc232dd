#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "ident/triangle.hpp"

namespace jointid::ident {

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

  std::size_t columns() const { return columns_; }
  Reduction reduction() const { return reduction_; }
  const std::map<Columns, Triangle>& triangles() const { return triangles_; }
  std::size_t rows_pushed() const;
  std::size_t bytes() const;  ///< of all triangles and buffers

  /// Reduces all buffers; needed before the triangles are read.
  void flush();
  void merge(Accumulator& other);
  void clear() { triangles_.clear(); }

 private:
  std::size_t columns_;
  Reduction reduction_;
  std::map<Columns, Triangle> triangles_;
};

}  // namespace jointid::ident
