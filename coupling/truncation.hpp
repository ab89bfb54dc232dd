#pragma once

#include "coupling/condition.hpp"

namespace jointid::coupling {

/// S⁺ = Σ_{i≤k} v_i u_iᴴ/σ_i over the k largest singular values of S (docs/formulas.md §8, 5.66).
struct Truncation {
  ComplexMatrix inverse;      ///< [m, m]
  Eigen::VectorXd sigma;      ///< [m] descending
  Index kept = 0;             ///< k
  Eigen::VectorXd limit;      ///< [m] what σ_i has to exceed; 0 behind the first that was dropped
};

/// Keeps σ_i > epsilon·σ_1 (5.67).
Truncation truncate_fixed(const MatrixRef& s, double epsilon);

/// Keeps the singular values that are told apart from zero: σ_i > 3τ_i with τ_i² = Σ_pq |u_pi|² v_pq |v_qi|², the variance of
/// u_iᴴ E v_i for errors E of S with E|E_pq|² = v_pq that are independent. `variance`: v, [m, m].
Truncation truncate_noise(const MatrixRef& s, const Eigen::Ref<const Eigen::MatrixXd>& variance);

/// Discrete Picard condition (Hansen 1990): with c_i = ‖u_iᴴ Y‖/σ_i, the part of the connecting forces along v_i, drops all from
/// the first i with c_i > 3 max_{j<i} c_j. A singular value so small that the forces grow is one of the errors. On the L-curve
/// this is the corner, from which ‖forces‖ grows while the gaps ‖Y − S f‖ hardly close. `y`: B H, [m, any].
Truncation truncate_picard(const MatrixRef& s, const MatrixRef& y);

}  // namespace jointid::coupling
