#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

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

}  // namespace jointid::ident
