#pragma once

#include <Eigen/SparseCore>

namespace jointid::models {

/// Symmetric N × N matrices in SI units: M ẍ + C ẋ + (K(1 + iη) + iD) x = p.
struct StructureMatrices {
  Eigen::SparseMatrix<double> mass, stiffness;
  Eigen::SparseMatrix<double> viscous_damping, hysteretic_damping;  ///< of no rows: none
  double loss_factor = 0.0;                                         ///< η ≥ 0
};

}  // namespace jointid::models
