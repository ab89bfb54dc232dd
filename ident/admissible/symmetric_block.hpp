#pragma once

#include <Eigen/Core>
#include <vector>

namespace jointid::ident {

/// Coefficient of an unknown in one element of a symmetric matrix; both triangles are listed.
struct BlockEntry {
  Eigen::Index row = 0, column = 0;
  double value = 0.0;
};

/// A condition S(θ) = S₀ + Σ θ_u E_u ⪰ 0 on unknowns θ, S symmetric m×m. A bound is the case m = 1.
struct SymmetricBlock {
  Eigen::MatrixXd constant;                           ///< S₀, [m×m]
  std::vector<Eigen::Index> unknowns;                 ///< those with coefficients, ascending
  std::vector<std::vector<BlockEntry>> coefficients;  ///< E_u, one per entry of `unknowns`

  Eigen::Index size() const { return constant.rows(); }

  /// Σ θ_u E_u.
  Eigen::MatrixXd linear_part(const Eigen::VectorXd& theta) const;
  Eigen::MatrixXd at(const Eigen::VectorXd& theta) const { return constant + linear_part(theta); }

  /// Adds ⟨E_u, Y⟩ to element u of `to`: the adjoint of linear_part().
  void add_adjoint(const Eigen::MatrixXd& y, Eigen::VectorXd& to) const;
};

/// The same condition on D S D, D = diag(scale).
SymmetricBlock scaled(SymmetricBlock block, const Eigen::VectorXd& scale);

/// Per row a power of two that brings the elements of S near 1, by the sizes of S(θ), or of the coefficients where that is 0.
Eigen::VectorXd balance(const SymmetricBlock& block, const Eigen::VectorXd& theta);

/// Least eigenvalue of a symmetric matrix.
double least_eigenvalue(const Eigen::MatrixXd& symmetric);

}  // namespace jointid::ident
