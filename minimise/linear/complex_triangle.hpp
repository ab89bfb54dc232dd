#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "minimise/linear/triangle.hpp"

namespace jointid::minimise {

/// Running QR of a complex system in z = k + i·d. Where stiffness and hysteretic damping have the same pattern, the real and
/// imaginary rows of every equation, [Re e, −Im e] and [Im e, Re e] over (k, d), are one complex equation e·z: half the work
/// of the real triangle and the same least-squares problem. Rows have stride() numbers: the real parts of the unknowns and
/// the right-hand side, and, half() further on, the imaginary parts.
class ComplexTriangle {
 public:
  explicit ComplexTriangle(std::size_t unknowns);

  std::size_t stride() const { return 2 * half_; }
  std::size_t bytes() const { return (triangle_.size() + buffer_.size() + scratch_.size()) * sizeof(double); }
  static std::size_t half(std::size_t unknowns);

  /// Room for `count` new rows, zero-filled.
  double* append(std::size_t count);

  /// Moves everything into a real triangle: k_u is its column real_columns[u], d_u imaginary_columns[u].
  void pour(std::span<const std::size_t> real_columns, std::span<const std::size_t> imaginary_columns, Triangle& to);

 private:
  void flush();

  std::size_t unknowns_, half_, capacity_, buffered_ = 0, pushed_ = 0;
  std::vector<double> triangle_, buffer_, scratch_;
};

}  // namespace jointid::minimise
