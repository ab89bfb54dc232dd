#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

namespace jointid::dense {

/// A P = Q R with column pivoting (|r₁₁| ≥ |r₂₂| ≥ …): least squares, rank, ranges.
template <class Matrix>
class PivotedQr {
 public:
  using Vector = Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, 1>;
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  /// A pivot counts when |r_ii| > threshold·|r₁₁|; by default threshold = eps·min(rows, columns).
  explicit PivotedQr(const Eigen::Ref<const Matrix>& a, std::optional<double> threshold = std::nullopt);

  Eigen::Index rank() const;
  /// min ‖Ax − b‖; beyond the rank the permuted x is 0.
  Vector solve(const Eigen::Ref<const Vector>& b) const;
  /// R: upper triangular, min(rows, columns) × columns.
  Matrix triangle() const;
  const Permutation& permutation() const;
  /// The first `count` columns of Q.
  Matrix orthonormal_columns(Eigen::Index count) const;
  /// Qᴴ B
  Matrix rotated(const Eigen::Ref<const Matrix>& b) const;

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

using RealPivotedQr = PivotedQr<Eigen::MatrixXd>;
using ComplexPivotedQr = PivotedQr<Eigen::MatrixXcd>;
extern template class PivotedQr<Eigen::MatrixXd>;
extern template class PivotedQr<Eigen::MatrixXcd>;

}  // namespace jointid::dense
