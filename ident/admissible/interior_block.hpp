#pragma once

#include "ident/admissible/symmetric_block.hpp"

namespace jointid::ident {

/// One condition S(x) ⪰ 0 of the interior-point method at its current iterate: S ≻ 0 and Λ ≻ 0, scaled so that the elements of S
/// are near 1 at the origin.
class InteriorBlock {
 public:
  InteriorBlock(const SymmetricBlock& block, const Eigen::VectorXd& origin, const Eigen::MatrixXd& basis);

  /// How far S(0) is outside (largest violation) or 0, and how much S changes over a unit of x, at most its own size.
  double violation() const { return violation_; }
  double sensitivity() const { return sensitivity_; }

  /// Begins with S(0), its eigenvalues raised to at least violation() or sensitivity(), and S Λ = μ I.
  void begin(double mu);

  /// Factors S and Λ at x; false when rounding has made one of them singular.
  bool factor(const Eigen::VectorXd& x);

  /// 𝒜*(Λ S⁻¹ 𝒜(·)), over x.
  void add_curvature(Eigen::MatrixXd& to) const;

  /// The part 𝒜*(σμ S⁻¹ − S⁻¹ (S(x) − S) Λ − second order) of the right side of a step.
  Eigen::VectorXd pull(double sigma_mu, bool second_order) const;

  /// Works out dS and dΛ for a step dx.
  void direct(const Eigen::VectorXd& dx, double sigma_mu, bool second_order);

  double room() const;                    ///< how far both can go along it, at most 1/0.95
  double gap() const { return s_.cwiseProduct(lambda_).sum(); }
  double rounding() const { return 1e-15 * s_.norm() * lambda_.norm(); }  ///< of the gap
  double gap_after(double length) const;  ///< tr((S + αdS)(Λ + αdΛ))
  void advance(double length);

  Eigen::Index size() const { return of_.size(); }
  double missing() const { return missing_.cwiseAbs().maxCoeff(); }  ///< of S(x) − S
  Eigen::VectorXd force() const { return adjoint(lambda_); }         ///< 𝒜*(Λ)

  /// S(x) and Λ in the units of the block.
  Eigen::MatrixXd value(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd multiplier() const;
  Eigen::Index at_limit() const;  ///< eigenvalues of S below sensitivity² times what Λ has in their directions

 private:
  Eigen::MatrixXd along(const Eigen::VectorXd& x) const;
  Eigen::VectorXd adjoint(const Eigen::MatrixXd& y) const;

  Eigen::VectorXd scale_;
  SymmetricBlock of_;      ///< its unknowns are the rows of basis_
  Eigen::MatrixXd basis_, at_origin_;
  double violation_ = 0.0, sensitivity_ = 0.0;
  Eigen::MatrixXd s_, lambda_, s_inverse_, missing_, ds_, d_lambda_;
  Eigen::MatrixXd s_root_, lambda_root_;  ///< lower Cholesky factors
};

}  // namespace jointid::ident
