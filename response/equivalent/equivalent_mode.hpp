#pragma once

#include <vector>

#include "response/joint/joint.hpp"
#include "response/structure/matrix_structure.hpp"

namespace jointid::response {

/// F₁/Q₁ = k_e + id_e of a joint under q = |Q₁| cos ωt (R4.42, R4.49); with a dashpot d_e has ωc.
struct EquivalentJoint {
  double stiffness = 0.0;  ///< k_e, N/m
  double damping = 0.0;    ///< d_e = (energy lost in a period)/(π|Q₁|²), N/m
};
EquivalentJoint equivalent_joint(const Joint& joint, double amplitude, double omega);

/// A mode of K + W k_e Wᵀ with the joints' stiffnesses at the amplitudes that it gives them.
struct EquivalentMode {
  bool converged = false;
  double amplitude = 0.0;            ///< |q| of the joint asked for, m
  double omega = 0.0;                ///< rad/s
  double loss_factor_joints = 0.0;   ///< Σ d_e (Wᵀφ)²/ω², φᵀMφ = 1
  double loss_factor_viscous = 0.0;  ///< φᵀCφ/ω
  std::vector<EquivalentJoint> joints;
  Eigen::VectorXd motion;  ///< amplitudes of all coordinates, m; the sign is that of the joint's positive end
};

/// Mode number `mode` (from 0) when the joint `of` moves with `amplitude` > 0. With several joints their amplitudes follow from
/// the shape, which is iterated to a change of 1e-12. A first estimate of peaks: pure sines, real modes. Throws InputError when
/// the joint stands still in the mode, or there is no such mode.
EquivalentMode equivalent_mode(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints,
                               Eigen::Index mode, std::size_t of, double amplitude);

}  // namespace jointid::response
