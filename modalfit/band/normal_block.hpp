#pragma once

#include <Eigen/Core>

#include "modalfit/band/band.hpp"
#include "modalfit/band/basis.hpp"

namespace jointid::modalfit {

/// The basis as real rows: [2F, columns], real and imaginary part of a line below each other; shared by all entries.
struct RealBasis {
  Eigen::MatrixXd columns;
  Eigen::MatrixXd derivatives;  ///< [2F, mode·2·per_mode + parameter·per_mode + own]; empty when the basis has none
  Eigen::Index modes = 0, per_mode = 1;

  explicit RealBasis(const Basis& basis);
};

/// The weighted least-squares problem of one FRF, min ‖W(y − Xc)‖², by its column-scaled normal equations, whose factor a
/// ridge of 1e-12 keeps apart from zero. Where the residual is below 1e-6 of the FRF (data without noise) the solution is corrected for
/// both.
class NormalBlock {
 public:
  NormalBlock(const RealBasis& basis, const Band& band, std::size_t entry);

  const Eigen::VectorXd& coefficients() const { return coefficients_; }
  double cost() const { return cost_; }        ///< ‖W(y − Xc)‖²
  double equations() const { return equations_; }  ///< rows with a weight
  const Eigen::VectorXd& residual() const { return residual_; }  ///< [2F] W(y − Xc)
  /// (XᵀW²X)⁻¹B.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

  /// What the poles change: D = ∂(Xc)/∂θ at fixed c, θ = (ln f_1, damping_1, ln f_2, …).
  struct PoleTerms {
    Eigen::MatrixXd cross;     ///< XᵀW²D
    Eigen::MatrixXd curvature; ///< DᵀW²D − crossᵀ(XᵀW²X)⁻¹cross: of the cost with c eliminated
    Eigen::VectorXd gradient;  ///< DᵀW²(y − Xc)
  };
  PoleTerms pole_terms(const RealBasis& basis) const;
  /// [2F,2N] W(D − X(XᵀW²X)⁻¹XᵀW²D): rows of the Jacobian of the poles with c eliminated.
  Eigen::MatrixXd pole_rows(const RealBasis& basis) const;

 private:
  void correct(const Eigen::VectorXd& y);
  Eigen::MatrixXd weighted_slopes(const RealBasis& basis) const;  ///< WD

  Eigen::VectorXd weight_;    ///< [2F]
  Eigen::MatrixXd weighted_;  ///< WX
  Eigen::VectorXd scale_, coefficients_, residual_;  ///< residual W(y − Xc)
  Eigen::MatrixXd factor_;    ///< lower Cholesky factor of the scaled XᵀW²X
  double cost_ = 0.0, equations_ = 0.0;
};

}  // namespace jointid::modalfit
