#pragma once

#include <Eigen/Core>
#include <memory>

namespace jointid::dense {

/// P A = L U of a square real matrix with partial pivoting, factored once for several right-hand sides.
class RealLu {
 public:
  explicit RealLu(const Eigen::Ref<const Eigen::MatrixXd>& a);

  /// A⁻¹ B; numbers that are not finite where A is singular.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

}  // namespace jointid::dense
