#pragma once

#include "ident/admissible/symmetric_block.hpp"

namespace jointid::ident {

/// What solve_semidefinite() found. With 𝒜_k the linear part of block k in x, the conditions of Karush, Kuhn and Tucker are
/// x = Σ_k 𝒜_k*(Λ_k), S_k ⪰ 0, Λ_k ⪰ 0, S_k Λ_k = 0.
struct SemidefiniteFit {
  Eigen::VectorXd x;
  std::vector<Eigen::MatrixXd> value;       ///< S_k at x, positive definite
  std::vector<Eigen::MatrixXd> multiplier;  ///< Λ_k, positive definite
  /// Per block how many eigenvalues of S are zero: those nearer to 0, in units of x, than Λ pulls.
  std::vector<Eigen::Index> at_limit;
  double gap = 0.0;                         ///< Σ tr(S_k Λ_k) ≥ ½‖x‖² − ½‖x*‖²
  std::size_t iterations = 0;
  bool converged = false;  ///< gap ≤ 1e-8·max(1, ‖x‖²) but for rounding of S: ‖x − x*‖ ≤ √(2·gap)
};

/// Semidefinite least squares in few unknowns: min ½‖x‖² subject to S_k(θ) ⪰ 0 for all k, θ = origin + basis·x. Needs a θ with
/// all S_k ≻ 0. A predictor–corrector primal–dual interior-point method with the direction of Helmberg, Rendl, Vanderbei and
/// Wolkowicz (1996), Kojima, Shindoh and Hara (1997) and Monteiro (1997) from an infeasible start; 10 to 30 iterations of cost
/// O(n³ + Σ n_k·m_k³) as a rule. The result is inside the constraints: no S_k has an eigenvalue below zero but for rounding.
SemidefiniteFit solve_semidefinite(const std::vector<SymmetricBlock>& blocks, const Eigen::VectorXd& origin,
                                   const Eigen::MatrixXd& basis);

}  // namespace jointid::ident
