#pragma once

#include <Eigen/Core>

#include "minimise/linear/accumulator.hpp"

namespace jointid::minimise {

/// The rows of a flushed accumulator reduced to n+1 rows [R | q]: for every y, ‖R y − q‖² is the sum of squares of all compressed
/// weighted rows. Upper triangular with Reduction::orthogonal.
Eigen::MatrixXd reduced_system(const Accumulator& accumulator);

/// [E|p]ᵀ[E|p] of an accumulator with Reduction::normal.
Eigen::MatrixXd normal_product(const Accumulator& accumulator);

}  // namespace jointid::minimise
