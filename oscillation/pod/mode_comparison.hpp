#pragma once

#include <cstddef>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// |φ_iᵀMψ_j|/√(φ_iᵀMφ_i ψ_jᵀMψ_j) of all pairs of columns, [modes of φ, modes of ψ]: the cosine in the inner product M, the
/// plain one for an empty M. Its square without M is the MAC. Columns of zeros give 0. Proper orthogonal modes are the normal
/// modes only where the motion is free and undamped with distinct frequencies, the record long and the inner product M: unequal
/// masses without weighting give cosines down to 0.82 where weighting gives 1 (../shared/theory/friction-oscillations.md, 1).
Eigen::MatrixXd mode_cosines(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass = {});

/// The square of mode_cosines() without a mass matrix: the modal assurance criterion.
Eigen::MatrixXd mode_assurance(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi);

/// |v_k|/Σ|v| of φ_i = Σ v_k ψ_k, rows sum to 1, [modes of φ, modes of ψ]: how much each ψ contributes to a φ (Kappagantu's Tables
/// 5.1, 5.2). ψ are scaled to length 1 in the inner product M, and v is the least-squares solution in it. `outside`: the part of |φ|²
/// that the ψ do not reach, a share. A φ of zeros, or out of reach altogether, has a row of zeros. Throws InputError (data) for ψ that
/// depend on each other.
struct ModeContributions {
  Eigen::MatrixXd shares;
  Eigen::VectorXd outside;
};
ModeContributions mode_contributions(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass = {});

/// Each φ with the ψ that is most alike, largest cosines first, each ψ once.
struct ModePair {
  std::size_t phi = 0, psi = 0;
  double cosine = 0.0;
};
std::vector<ModePair> matched_modes(const Eigen::MatrixXd& cosines);

}  // namespace jointid::oscillation
