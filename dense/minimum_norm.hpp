#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

namespace jointid::dense {

/// The least-squares solution of smallest norm of systems of any rank, by a complete orthogonal decomposition.
template <class Matrix>
class MinimumNorm {
 public:
  /// A pivot counts when it is above threshold times the largest; by default eps·min(rows, columns).
  explicit MinimumNorm(const Eigen::Ref<const Matrix>& a, std::optional<double> threshold = std::nullopt);

  Eigen::Index rank() const;
  /// A⁺ B
  Matrix solve(const Eigen::Ref<const Matrix>& b) const;
  Matrix pseudo_inverse() const;

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

using RealMinimumNorm = MinimumNorm<Eigen::MatrixXd>;
using ComplexMinimumNorm = MinimumNorm<Eigen::MatrixXcd>;
extern template class MinimumNorm<Eigen::MatrixXd>;
extern template class MinimumNorm<Eigen::MatrixXcd>;

}  // namespace jointid::dense
