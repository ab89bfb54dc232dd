#pragma once

#include <Eigen/Core>

namespace jointid::response {

<<<<<<< HEAD
/// A structure without the forces of its friction joints: M ẍ + C ẋ + K x = p, N × N matrices in SI units; M symmetric and
/// positive definite, C and K symmetric and positive semidefinite. Linear joints may be part of them.
=======
/// M ẍ + C ẋ + K x = p without the forces of joints: N × N matrices (kg, N·s/m, N/m, or their rotary units).
>>>>>>> response
struct MatrixStructure {
  Eigen::MatrixXd mass, damping, stiffness;
};

}  // namespace jointid::response
