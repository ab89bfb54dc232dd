#pragma once

#include <Eigen/Core>

namespace jointid::dense {

/// C += A Aᴴ, the lower triangle of a Hermitian matrix: imaginary parts of its diagonal are not read.
void add_square(const Eigen::Ref<const Eigen::MatrixXcd>& a, Eigen::Ref<Eigen::MatrixXcd> c);

/// C −= A Aᴴ, likewise.
void subtract_square(const Eigen::Ref<const Eigen::MatrixXcd>& a, Eigen::Ref<Eigen::MatrixXcd> c);

/// C += A Bᴴ.
void add_product(const Eigen::Ref<const Eigen::MatrixXcd>& a, const Eigen::Ref<const Eigen::MatrixXcd>& b,
                 Eigen::Ref<Eigen::MatrixXcd> c);

/// C −= Aᴴ B.
void subtract_adjoint_product(const Eigen::Ref<const Eigen::MatrixXcd>& a, const Eigen::Ref<const Eigen::MatrixXcd>& b,
                              Eigen::Ref<Eigen::MatrixXcd> c);

/// L of A = L Lᴴ in place of the lower triangle. False when A is not positive definite; it is spoilt then.
bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXcd> a);

/// L⁻¹ B and L⁻ᴴ B in place, L in a lower triangle.
void solve_lower(const Eigen::Ref<const Eigen::MatrixXcd>& l, Eigen::Ref<Eigen::MatrixXcd> b);
void solve_lower_adjoint(const Eigen::Ref<const Eigen::MatrixXcd>& l, Eigen::Ref<Eigen::MatrixXcd> b);

/// Large ones are left to the module blas where it is there: OpenBLAS built with POSIX threads, the only build that threads of the
/// caller may share; it has kernels for the machine it runs on (four times as fast as Eigen's for every x86-64). It uses one thread.
bool has_blas();

}  // namespace jointid::dense
