#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// A = U Σ Vᴴ, σ₁ ≥ σ₂ ≥ … ≥ 0. Vectors that were not asked for are empty.
template <class Matrix>
struct Svd {
  Matrix u;
  Eigen::VectorXd sigma;  ///< min(rows, columns) of them
  Matrix v;               ///< A v_i = σ_i u_i
};
using RealSvd = Svd<Eigen::MatrixXd>;
using ComplexSvd = Svd<Eigen::MatrixXcd>;

/// Which singular vectors: none, the first min(rows, columns), or a whole orthonormal basis.
enum class Vectors { none, thin, full };

/// By divide and conquer, below 16 columns by Jacobi rotations (Eigen's BDCSVD): σ to eps·σ₁.
RealSvd svd(const Eigen::Ref<const Eigen::MatrixXd>& a, Vectors u, Vectors v);
ComplexSvd svd(const Eigen::Ref<const Eigen::MatrixXcd>& a, Vectors u, Vectors v);

/// By Jacobi rotations alone: slower for large matrices, small σ more accurate where columns differ in scale.
RealSvd jacobi_svd(const Eigen::Ref<const Eigen::MatrixXd>& a, Vectors u, Vectors v);
ComplexSvd jacobi_svd(const Eigen::Ref<const Eigen::MatrixXcd>& a, Vectors u, Vectors v);

}  // namespace jointid::dense
