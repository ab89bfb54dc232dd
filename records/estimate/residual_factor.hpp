#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace jointid::records {

/// Of errors E [R,n] that a fit to the directions d [m,n] left, E dᴴ = 0: a factor L [R,n−m] with L Lᴴ = E Eᴴ, by Householder's
/// reflections of the blows that turn each direction to an axis on which nothing of E is left. A row that is not finite becomes NaN.
Eigen::MatrixXcd residual_factor(Eigen::MatrixXcd errors, Eigen::MatrixXcd directions);

}  // namespace jointid::records
