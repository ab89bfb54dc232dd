#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// min over U of ‖R + BU‖² + ‖U‖² for one B and many right-hand sides R, column by column.
class Ridge {
 public:
  explicit Ridge(Eigen::MatrixXd b);

  const Eigen::MatrixXd& b() const { return b_; }

  /// U = −(I + BᵀB)⁻¹BᵀR = −Bᵀ(I + BBᵀ)⁻¹R by the Cholesky factor of the smaller of the two, and one step of refinement.
  Eigen::MatrixXd best(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

  /// At most as many rows as R has columns, with the inner products that [R + BU; U] has: what the best U leaves.
  Eigen::MatrixXd left(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

 private:
  Eigen::MatrixXd first(const Eigen::Ref<const Eigen::MatrixXd>& r) const;
  Eigen::MatrixXd step(const Eigen::Ref<const Eigen::MatrixXd>& r, const Eigen::MatrixXd& u) const;

  Eigen::MatrixXd b_, lower_;
};

}  // namespace jointid::dense
