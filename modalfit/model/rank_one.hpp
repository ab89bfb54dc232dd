#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "modalfit/model/shape_covariance.hpp"

namespace jointid::modalfit {

/// An element of a symmetric matrix that was measured, maybe in both roles and several times.
struct RankOneDatum {
  std::size_t row = 0, column = 0;
  std::complex<double> value;
  double weight = 0.0;  ///< 1/variance of the complex value
};

struct RankOne {
  std::vector<std::complex<double>> vector;  ///< [n]; 0 where nothing tells
  ShapeCovariance covariance;
  double misfit = 0.0;  ///< cost over its degrees of freedom; NaN without redundancy
};

/// Core of the coordinates of some data: their columns or their rows, whichever are fewer.
Core core_of(const std::vector<RankOneDatum>& data, std::size_t size);

/// φ that minimises Σ weight·|value − φ_row φ_column|² (Gauss–Newton). `real`: φ real; values are then real. The sign is that which
/// makes the largest element positive (its real part). Normal equations join coordinates of the core with all, and others with the
/// core alone, which are eliminated: the cost of a step is n·k² for a core of k, linear in the responses of one reference.
RankOne fit_rank_one(const std::vector<RankOneDatum>& data, std::size_t size, bool real);

}  // namespace jointid::modalfit
