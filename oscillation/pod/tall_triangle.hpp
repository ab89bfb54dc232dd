#pragma once

#include <cstddef>
#include <vector>

namespace jointid::oscillation {

/// The triangle R of [o X] = QR of a tall matrix whose rows (o_i, x_i) come one after another: o a column that stands alone (ones, for
/// the mean), X [m, n]. Rows are gathered and taken below the triangle by Householder reflections in panels of 8 columns, applied to
/// the rest as products of matrices (compact WY form: Schreiber & Van Loan 1989; the zeros of a triangle above new rows stay out of
/// them). 2n² operations a row.
class TallTriangle {
 public:
  explicit TallTriangle(std::size_t columns);

  std::size_t columns() const { return columns_; }
  /// Adds the row (one, row[0 … n − 1]) unless a number of it is not finite, and says whether it did.
  bool push(double one, const double* row);
  /// Takes in what was pushed; before it the rest shows an older triangle.
  void flush();

  /// R(0, 0), R(0, 1 + j), and R(1 + i, 1 + j) for i ≤ j.
  double corner() const { return corner_; }
  double top(std::size_t j) const { return top_[j]; }
  double operator()(std::size_t i, std::size_t j) const { return triangle_[i * width_ + j]; }

 private:
  std::size_t columns_, width_;  ///< width: columns of whole panels
  std::size_t count_ = 0;        ///< rows that wait
  double corner_ = 0.0;
  std::vector<double> top_, triangle_;
  std::vector<double> ones_, panels_;  ///< of the waiting rows; panel by panel, in it row by row
};

}  // namespace jointid::oscillation
