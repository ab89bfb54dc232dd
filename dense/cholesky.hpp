#pragma once

#include <Eigen/Core>
#include <optional>

namespace jointid::dense {

/// L of A = L Lᵀ, A symmetric of which the lower triangle is read; empty when A is not positive definite.
std::optional<Eigen::MatrixXd> cholesky(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// The same in place: L replaces the lower triangle of A. False when A is not positive definite; it is spoilt then.
bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXd> a);

/// Lower L of A = L Lᴴ, A Hermitian and positive semidefinite, of which the lower triangle is read: a column whose pivot is below
/// 1e-12 of its diagonal element, which rounding makes, is zero. L of a multiple c A is √c L.
Eigen::MatrixXcd semidefinite_cholesky(const Eigen::Ref<const Eigen::MatrixXcd>& a);

/// L⁻¹ B and L⁻ᵀ B in place, L in a lower triangle.
void solve_lower(const Eigen::Ref<const Eigen::MatrixXd>& l, Eigen::Ref<Eigen::MatrixXd> b);
void solve_lower_transposed(const Eigen::Ref<const Eigen::MatrixXd>& l, Eigen::Ref<Eigen::MatrixXd> b);

/// A⁻¹ B by Cholesky factors, without a look at whether A is positive definite.
Eigen::MatrixXd solve_positive(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);
Eigen::MatrixXcd solve_positive(const Eigen::Ref<const Eigen::MatrixXcd>& a, const Eigen::Ref<const Eigen::MatrixXcd>& b);

/// A⁻¹ b of a positive definite A, and an estimate of 1/(‖A‖₁ ‖A⁻¹‖₁); empty when A is not positive definite.
struct CholeskySolution {
  Eigen::MatrixXd lower;
  Eigen::VectorXd x;
  double reciprocal_condition = 0.0;
};
std::optional<CholeskySolution> solve_definite(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::VectorXd>& b);

/// A⁻¹ B of a symmetric A that need not be positive definite, by L D Lᵀ with diagonal pivoting.
Eigen::MatrixXd solve_symmetric(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace jointid::dense
