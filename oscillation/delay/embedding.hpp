#pragma once

#include <cstddef>
#include <span>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// A delay embedding (Takens 1981): y_i = (x_i, x_{i+T}, …, x_{i+(d−1)T}).
struct Embedding {
  std::size_t dimension = 3;  ///< d ≥ 1
  std::size_t delay = 1;      ///< T ≥ 1, samples
};

/// The first `count` points, a row each; all n − (d−1)T that there are for 0. Throws InputError when there are fewer, for options
/// that are 0 and for numbers that are not finite.
RowMatrixXd delay_points(std::span<const double> x, const Embedding& embedding, std::size_t count = 0);

}  // namespace jointid::oscillation
