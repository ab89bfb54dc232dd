#pragma once

#include "base/eigen.hpp"
#include "ident/likelihood/elimination/element_weights.hpp"
#include "ident/likelihood/line/line_factors.hpp"

namespace jointid::ident {

/// Squares of the rows of A, B and D of a line by the columns that they touch, N×N each, Hermitian:
///   S_k = Σ_p w_A(p,k)² conj(P_p) P_pᵀ + Σ_r w_D(r,k)² conj(h_r) h_rᵀ,   R_k = Σ_r w_D(k,r)² conj(G_r) G_rᵀ,
///   B_q = Σ_p w_B(p,q)² conj(P_p) P_pᵀ,   P_p row p of P, G = Z A.
/// All k together are one real product: of squared weights, and of the numbers that a square of one row has.
class RowSquares {
 public:
  void take(const LineLayout& layout, const Eigen::VectorXd& weights, const LineFactors& factors);

  using Square = Eigen::Map<const ComplexMatrix>;
  Square s(std::size_t k) const { return of(s_, k); }
  Square r(std::size_t k) const { return of(r_, k); }
  Square b(std::size_t q) const { return of(b_, q); }

 private:
  Square of(const ComplexMatrix& squares, std::size_t k) const {
    const Eigen::Index n = joint_;
    return {squares.col(static_cast<Eigen::Index>(k)).data(), n, n};
  }
  void add_products(const RowMatrixXd& weights, const RowMatrixXd& numbers, ComplexMatrix& out);

  Eigen::Index joint_ = 0;
  RowMatrixXd seconds_, firsts_, of_b_;  ///< squared weights: rows × columns of X, of B
  RowMatrixXd by_p_and_h_, by_g_;        ///< of every row the real and imaginary parts of its square's lower triangle
  RowMatrixXd sums_;
  ComplexMatrix s_, r_, b_;  ///< N²×n, N²×N
};

}  // namespace jointid::ident
