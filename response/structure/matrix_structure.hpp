#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// A structure without the forces of its friction joints: M ẍ + C ẋ + K x = p, N × N matrices in SI units; M symmetric and
/// positive definite, C and K symmetric and positive semidefinite. Linear joints may be part of them.
struct MatrixStructure {
  Eigen::MatrixXd mass, damping, stiffness;
};

}  // namespace jointid::response
