#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// C = 2ζ MΦ diag(ω_r) ΦᵀM: the same share of critical damping in every mode of the structure without joints (R3.66), ΦᵀMΦ = I.
Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio);

}  // namespace jointid::response
