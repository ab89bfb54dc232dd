#pragma once

#include <Eigen/Core>
#include <cmath>

namespace jointid::minimise {

/// Power of two nearest to 1/norm (1 for a zero or non-finite norm): scaling by it rounds nothing.
inline double power_of_two_scale(double norm) {
  return norm > 0.0 && std::isfinite(norm) ? std::exp2(-std::round(std::log2(norm))) : 1.0;
}

/// One scale per column.
template <class Derived>
Eigen::VectorXd power_of_two_scales(const Eigen::MatrixBase<Derived>& matrix) {
  Eigen::VectorXd scale(matrix.cols());
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) scale[j] = power_of_two_scale(matrix.col(j).stableNorm());
  return scale;
}

}  // namespace jointid::minimise
