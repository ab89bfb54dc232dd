#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// M ẍ + C ẋ + K x = p without the forces of joints: N × N matrices (kg, N·s/m, N/m, or their rotary units).
struct MatrixStructure {
  Eigen::MatrixXd mass, damping, stiffness;
};

}  // namespace jointid::response
