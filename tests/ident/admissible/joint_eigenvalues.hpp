#pragma once

#include <algorithm>
#include <cmath>

#include "dense/eigen.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Least over largest eigenvalue of a symmetric matrix, row by row.
inline double least_relative_eigenvalue(const std::vector<double>& matrix) {
  const auto size = static_cast<Eigen::Index>(std::lround(std::sqrt(double(matrix.size()))));
  const Eigen::Map<const Eigen::MatrixXd> whole(matrix.data(), size, size);
  const Eigen::VectorXd values = dense::symmetric_eigenvalues(whole);
  return values[0] / values[size - 1];
}

/// Of all matrices of a solution.
inline double least_relative_eigenvalue(const Solution& solution) {
  double least = 1.0;
  for (const BandMatrices& band : solution.bands) {
    for (const auto& [kind, rows] : band.matrices) {
      std::vector<double> flat;
      for (const auto& row : rows) flat.insert(flat.end(), row.begin(), row.end());
      least = std::min(least, least_relative_eigenvalue(flat));
    }
  }
  return least;
}

}  // namespace jointid::ident
