#pragma once

#include "oscillation/pod/pod.hpp"
#include "oscillation/system/contact_system.hpp"

namespace jointid::oscillation {

/// A subspace in which a structure is to move, q = mean + Φ a.
struct ReductionBasis {
  Eigen::MatrixXd columns;  ///< Φ [n, m], ΦᵀMΦ = I unless said otherwise
  Eigen::VectorXd mean;     ///< [n]
};

/// The first m normal modes, KΦ = MΦΩ², nothing at the contact. Throws InputError unless 1 ≤ m ≤ n.
ReductionBasis normal_modes(const Mechanics& mechanics, Eigen::Index count);

/// The static deflection by a force at the contact, K⁻¹p, and the first m − 1 modes with the contact held, pᵀφ = 0 (Hurty 1965;
/// Craig & Bampton 1968). Needs no measured motion. M-orthonormal, the static shape last to be made so: the span is what counts.
/// Throws InputError unless 1 ≤ m ≤ n, and for a structure that a force at the contact moves away (K not positive definite).
ReductionBasis craig_bampton(const Mechanics& mechanics, Eigen::Index count);

/// The first m proper orthogonal modes of records of q with their mean, orthonormal in the inner product of the decomposition.
ReductionBasis proper_modes(const oscillation::Pod& pod, Eigen::Index count);

/// The model on a basis, q = mean + Φ a in second-order form (6.27–6.36): ΦᵀMΦ ä + ΦᵀCΦ ȧ + ΦᵀKΦ a = Φᵀg − ΦᵀK·mean + Φᵀp f.
/// The stick force follows from the reduced model itself, which (3.31–3.34) do not. For a friction law whose normal load varies
/// with the motion, N = N₀ + N_m y, the mean's part of y goes into N₀.
Mechanics reduced(const Mechanics& full, const ReductionBasis& basis);
Friction reduced(const Friction& friction, const Mechanics& full, const ReductionBasis& basis);

/// What of a full state lies in the basis: (ΦᵀMΦ)⁻¹ΦᵀM(q − mean) and (ΦᵀMΦ)⁻¹ΦᵀM v, the nearest in the inner product M.
Eigen::VectorXd reduced_displacements(const Mechanics& full, const ReductionBasis& basis, const Eigen::VectorXd& q);
Eigen::VectorXd reduced_velocities(const Mechanics& full, const ReductionBasis& basis, const Eigen::VectorXd& v);

}  // namespace jointid::oscillation
