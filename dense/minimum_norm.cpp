#include "dense/minimum_norm.hpp"

#include <Eigen/QR>

namespace jointid::dense {

template <class Matrix>
struct MinimumNorm<Matrix>::Factors {
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
};

template <class Matrix>
MinimumNorm<Matrix>::MinimumNorm(const Eigen::Ref<const Matrix>& a, std::optional<double> threshold) {
  auto factors = std::make_shared<Factors>();
  if (threshold) factors->decomposition.setThreshold(*threshold);
  factors->decomposition.compute(a);
  factors_ = std::move(factors);
}

template <class Matrix>
Eigen::Index MinimumNorm<Matrix>::rank() const {
  return factors_->decomposition.rank();
}

template <class Matrix>
Matrix MinimumNorm<Matrix>::solve(const Eigen::Ref<const Matrix>& b) const {
  return factors_->decomposition.solve(b);
}

template <class Matrix>
Matrix MinimumNorm<Matrix>::pseudo_inverse() const {
  return factors_->decomposition.pseudoInverse();
}

template class MinimumNorm<Eigen::MatrixXd>;
template class MinimumNorm<Eigen::MatrixXcd>;

}  // namespace jointid::dense
