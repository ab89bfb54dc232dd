#pragma once

#include <Eigen/Core>
#include <memory>

namespace jointid::dense {

/// P A = L U of a square complex matrix with partial pivoting, factored once for several right-hand sides.
class ComplexLu {
 public:
  explicit ComplexLu(const Eigen::Ref<const Eigen::MatrixXcd>& a);

  /// A⁻¹ B; numbers that are not finite where A is singular.
  Eigen::MatrixXcd solve(const Eigen::Ref<const Eigen::MatrixXcd>& b) const;
  Eigen::MatrixXcd inverse() const;
  /// An estimate of 1/(‖A‖₁ ‖A⁻¹‖₁); 0 where a pivot is 0, 1 for an empty matrix.
  double reciprocal_condition() const;

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// A⁻¹ B and A⁻¹ of square matrices, by the same factors.
Eigen::MatrixXcd solve(const Eigen::Ref<const Eigen::MatrixXcd>& a, const Eigen::Ref<const Eigen::MatrixXcd>& b);
Eigen::MatrixXcd inverse(const Eigen::Ref<const Eigen::MatrixXcd>& a);

/// A⁻¹ of four rows and columns, by cofactors.
Eigen::Matrix4d inverse_4x4(const Eigen::Matrix4d& a);

}  // namespace jointid::dense
