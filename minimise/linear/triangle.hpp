#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::minimise {

/// How rows are reduced.
enum class Reduction {
  orthogonal,  ///< Householder: RᵀR = [E|p]ᵀ[E|p] to rounding, without forming the product
  normal       ///< the product itself: fast, and squares the condition number; only where the scene asks for it
};

/// Running QR of the tall real system [E | p]: keeps the upper triangle R of the rows pushed so far, (n+1)×(n+1) with the
/// right-hand side as last column, and reduces new rows against it by Householder reflections, a buffer at a time (TSQR).
/// The condition number is not squared. With Reduction::normal it keeps the upper triangle of [E|p]ᵀ[E|p] instead.
/// Memory is the triangle and one buffer, however many rows are pushed.
class Triangle {
 public:
  explicit Triangle(std::size_t unknowns, Reduction reduction = Reduction::orthogonal);

  std::size_t unknowns() const { return unknowns_; }
  std::size_t rows_pushed() const { return rows_pushed_; }
  std::size_t stride() const { return stride_; }
  std::size_t bytes() const { return (triangle_.size() + buffer_.size() + scratch_.size()) * sizeof(double); }

  /// Room for `count` new rows of unknowns()+1 numbers, `stride()` apart, zero-filled; they count as pushed.
  double* append(std::size_t count);

  /// Reduces what is in the buffer. Needed before triangle().
  void flush();

  /// Element (i,j), i ≤ j ≤ n, of the triangle after flush().
  double operator()(std::size_t i, std::size_t j) const { return triangle_[i * stride_ + j]; }

  /// Frees the buffer after flush(); further rows make a new one.
  void release();

  /// Adds the rows of another triangle over the same unknowns.
  void merge(Triangle& other);

  /// How many numbers packed() gives.
  static std::size_t packed_size(std::size_t unknowns) { return 1 + (unknowns + 1) * (unknowns + 2) / 2; }

  /// Appends all that another process needs to merge this triangle after flush(): rows_pushed() and its elements row by row.
  void pack(std::vector<double>& out) const;
  static Triangle unpacked(std::size_t unknowns, Reduction reduction, std::span<const double> packed);

 private:
  Reduction reduction_;
  std::size_t unknowns_, width_, stride_, capacity_;
  std::size_t buffered_ = 0, rows_pushed_ = 0;
  std::vector<double> triangle_;  ///< width × stride
  std::vector<double> buffer_;    ///< capacity × stride
  std::vector<double> scratch_;
};

}  // namespace jointid::minimise
