#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace jointid::modalfit {

/// An element of a symmetric matrix that was measured, maybe in both roles and several times.
struct RankOneDatum {
  std::size_t row = 0, column = 0;
  std::complex<double> value;
  double weight = 0.0;  ///< 1/variance of the complex value
};

struct RankOne {
  std::vector<std::complex<double>> vector;      ///< [n]; 0 where nothing tells
  std::vector<std::complex<double>> covariance;  ///< [n,n] row-major
  double misfit = 0.0;  ///< cost over its degrees of freedom; NaN without redundancy
};

/// φ that minimises Σ weight·|value − φ_row φ_column|² (Gauss–Newton). `real`: φ real; values are then real. The sign is that which
/// makes the largest element positive (its real part).
RankOne fit_rank_one(const std::vector<RankOneDatum>& data, std::size_t size, bool real);

}  // namespace jointid::modalfit
