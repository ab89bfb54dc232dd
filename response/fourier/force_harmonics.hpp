#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// F_n = A_n + iB_n of a force f(θ) = Σ Re F_n e^{inθ} under a periodic motion, with exact derivatives.
struct ForceHarmonics {
  Eigen::VectorXcd force;          ///< [harmonics of the force]
  Eigen::MatrixXcd by_motion;      ///< [harmonics of the force, unknowns of the motion (Harmonics::unknowns)]
  Eigen::MatrixXcd by_parameters;  ///< [harmonics of the force, parameters]; no columns unless asked for
  int reversals = 0;               ///< of the motion in a period
};

}  // namespace jointid::response
