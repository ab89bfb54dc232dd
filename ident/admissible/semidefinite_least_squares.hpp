#pragma once

#include "ident/admissible/semidefinite_fit.hpp"
#include "ident/admissible/symmetric_block.hpp"

namespace jointid::ident {

/// Semidefinite least squares in few unknowns: min ½‖x‖² subject to S_k(θ) ⪰ 0 for all k, θ = origin + basis·x. Needs a θ with
/// all S_k ≻ 0. A predictor–corrector primal–dual interior-point method with the direction of Helmberg, Rendl, Vanderbei and
/// Wolkowicz (1996), Kojima, Shindoh and Hara (1997) and Monteiro (1997) from an infeasible start; 10 to 30 iterations of cost
/// O(n³ + Σ n_k·m_k³) as a rule. The result is inside the constraints: no S_k has an eigenvalue below zero but for rounding.
SemidefiniteFit solve_semidefinite(const std::vector<SymmetricBlock>& blocks, const Eigen::VectorXd& origin,
                                   const Eigen::MatrixXd& basis);

}  // namespace jointid::ident
