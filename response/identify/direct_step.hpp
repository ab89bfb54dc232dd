#pragma once

#include "response/identify/measured_state.hpp"

namespace jointid::response {

/// What a measured state tells of the joints without any law.
struct DirectStep {
  double omega = 0.0;             ///< rad/s
  std::vector<int> harmonics;     ///< of the state's responses
  Eigen::MatrixXcd joint_force;   ///< F_n, [harmonic, joint]
  Eigen::MatrixXcd joint_motion;  ///< Q_n, [harmonic, joint]
  /// Standard deviations of real and imaginary part, to first order, of the errors of responses and forces and of those that the
  /// structure knows of its receptances, all independent. [harmonic, joint]
  Eigen::MatrixXcd force_deviation, motion_deviation;
  /// F₁/Q₁ = k_e + i d_e of each joint (R4.42), and deviations of real and imaginary part; empty without harmonic 1.
  Eigen::VectorXcd equivalent, equivalent_deviation;
  /// σ_min/σ_max of H_mW with columns of norm 1, the smallest of all harmonics: how well the responses tell the joints apart.
  double separation = 1.0;
};

/// F_n = −(H_mW)⁺(Y_n − H_mP_n), weighted by 1/deviation, Q_n = b_n − G_nF_n (H_m: rows of the responses). Needs neither a sine
/// nor control of the amplitude. Throws InputError (data) when rank H_mW is less than the number of joints at a harmonic.
DirectStep direct_step(const Receptance& structure, const MeasuredState& state);

}  // namespace jointid::response
